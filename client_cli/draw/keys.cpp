#include "client_cli/draw/keys.hpp"

#include <array>
#include <utility>

#include "common/record/text.hpp"

namespace breakshot::client {
namespace {

constexpr char escape_byte = '\x1b';

/// What follows ESC [ or ESC O, by xterm's control sequences and those of the Linux console.
std::optional<Special> special_of(std::string_view sequence) {
  static constexpr std::array<std::pair<std::string_view, Special>, 14> known = {{
      {"A", Special::up},
      {"B", Special::down},
      {"C", Special::right},
      {"D", Special::left},
      {"H", Special::home},
      {"F", Special::end},
      {"1~", Special::home},
      {"7~", Special::home},
      {"4~", Special::end},
      {"8~", Special::end},
      {"3~", Special::delete_},
      {"5~", Special::page_up},
      {"6~", Special::page_down},
      {"Z", Special::tab},
  }};
  for (const auto& [text, special] : known) {
    if (text == sequence) return special;
  }
  return std::nullopt;
}

std::optional<Special> control_of(char byte) {
  switch (byte) {
    case '\r':
    case '\n':
      return Special::enter;
    case '\t':
      return Special::tab;
    case '\b':
    case '\x7f':
      return Special::erase;
    default:
      return std::nullopt;
  }
}

/// How many bytes a UTF-8 sequence with this first byte has; 1 for what never starts one.
std::size_t utf8_length(char first) {
  const auto byte = static_cast<unsigned char>(first);
  if (byte < 0xc0 || byte > 0xf7) return 1;
  if (byte < 0xe0) return 2;
  return byte < 0xf0 ? 3 : 4;
}

}  // namespace

void KeyDecoder::feed(std::string_view bytes) {
  bytes_ += bytes;
}

std::optional<Key> KeyDecoder::next() {
  while (keys_.empty() && !bytes_.empty()) {
    const std::size_t used = decode_one();
    if (used == 0) return std::nullopt;
    bytes_.erase(0, used);
  }
  if (keys_.empty()) return std::nullopt;
  const Key key = keys_.front();
  keys_.pop_front();
  return key;
}

void KeyDecoder::pause() {
  if (bytes_.empty() || bytes_[0] != escape_byte) return;
  keys_.push_back(Special::escape);
  bytes_.clear();
}

void KeyDecoder::close() {
  bytes_.clear();
  keys_.push_back(Special::closed);
}

/// Decodes the first key and returns how many bytes it took; 0 where bytes are missing.
std::size_t KeyDecoder::decode_one() {
  if (bytes_[0] == escape_byte) return decode_escape();
  if (const auto special = control_of(bytes_[0])) {
    keys_.push_back(*special);
    return 1;
  }
  const std::size_t length = utf8_length(bytes_[0]);
  if (bytes_.size() < length) return 0;
  const record::Character character = record::first_of(bytes_);
  if (character.bytes == 0) return 1;
  if (!record::unprintable(character.code_point)) keys_.push_back(character.code_point);
  return character.bytes;
}

std::size_t KeyDecoder::decode_escape() {
  if (bytes_.size() < 2) return 0;
  if (bytes_[1] != '[' && bytes_[1] != 'O') {
    keys_.push_back(Special::escape);
    return 1;
  }
  // A sequence ends with its first byte in 0x40 to 0x7e (ECMA-48, section 5.4).
  for (std::size_t i = 2; i < bytes_.size(); ++i) {
    if (bytes_[i] < 0x40 || bytes_[i] > 0x7e) continue;
    if (const auto special = special_of(std::string_view(bytes_).substr(2, i - 1))) {
      keys_.push_back(*special);
    }
    return i + 1;
  }
  return bytes_.size() > max_escape_bytes ? bytes_.size() : 0;
}

}  // namespace breakshot::client
