// A terminal's screen, as far as our escape sequences reach: cursor positions, 24-bit colours,
// characters, clearing, and private modes, which change nothing here. Anything else is an error.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "client_cli/draw/grid.hpp"
#include "common/record/text.hpp"

namespace breakshot::client {

class Screen {
 public:
  explicit Screen(TerminalSize size) : grid_(size) {}

  const Grid& grid() const { return grid_; }

  void write(std::string_view text) {
    while (!text.empty()) text.remove_prefix(text[0] == '\x1b' ? control(text) : character(text));
  }

 private:
  Grid grid_;
  int column_ = 0;
  int row_ = 0;
  Cell pen_;

  std::size_t character(std::string_view text) {
    const record::Character read = record::first_of(text);
    if (read.bytes == 0) throw std::runtime_error("not UTF-8");
    const int width = columns_of(read.code_point);
    grid_.at(column_, row_) = pen_;
    grid_.at(column_, row_).glyph = read.code_point;
    if (width == 2) {
      grid_.at(column_ + 1, row_) = pen_;
      grid_.at(column_ + 1, row_).glyph = 0;
    }
    column_ += width;
    return read.bytes;
  }

  std::size_t control(std::string_view text) {
    // A sequence ends with its first byte in 0x40 to 0x7e (ECMA-48, section 5.4).
    std::size_t end = 2;
    while (end < text.size() && (text[end] < 0x40 || text[end] > 0x7e)) ++end;
    if (text.substr(0, 2) != "\x1b[" || end >= text.size()) {
      throw std::runtime_error("unknown escape sequence");
    }
    const std::string_view parameters = text.substr(2, end - 2);
    const bool is_mode = text[end] == 'h' || text[end] == 'l';
    if (!is_mode || parameters.substr(0, 1) != "?") act(text[end], numbers_of(parameters));
    return end + 1;
  }

  void act(char kind, const std::vector<int>& numbers) {
    if (kind == 'H') {
      row_ = numbers.at(0) - 1;
      column_ = numbers.at(1) - 1;
    } else if (kind == 'J' && numbers.at(0) == 2) {
      grid_ = Grid(grid_.size());
    } else if (kind == 'm' && numbers.at(0) == 0) {
      pen_ = Cell{};
    } else if (kind == 'm') {
      colour(numbers);
    } else {
      throw std::runtime_error("unknown escape sequence");
    }
  }

  void colour(const std::vector<int>& numbers) {
    if (numbers.size() != 5 || numbers[1] != 2) throw std::runtime_error("unknown colour");
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(numbers[i]); };
    (numbers[0] == 38 ? pen_.ink : pen_.ground) = {byte(2), byte(3), byte(4)};
  }

  static std::vector<int> numbers_of(std::string_view text) {
    std::vector<int> numbers(1);
    for (const char c : text) {
      if (c == ';') {
        numbers.push_back(0);
      } else {
        numbers.back() = numbers.back() * 10 + (c - '0');
      }
    }
    return numbers;
  }
};

}  // namespace breakshot::client
