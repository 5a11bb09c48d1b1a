// Keys out of the bytes that a terminal sends.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace breakshot::client {

enum class Special : std::uint8_t {
  left,
  right,
  up,
  down,
  home,
  end,
  page_up,
  page_down,
  erase,    ///< backspace
  delete_,  ///< the key that deletes forwards
  tab,
  enter,
  escape,
  resized,  ///< no key: the terminal has another size
  closed,   ///< no key: the terminal is gone
};

/// A character or a key that has none.
using Key = std::variant<char32_t, Special>;

/// Longest escape sequence that is waited for; longer ones are dropped.
inline constexpr std::size_t max_escape_bytes = 32;

class KeyDecoder {
 public:
  void feed(std::string_view bytes);
  /// The next key, if all of its bytes have come.
  std::optional<Key> next();
  /// Nothing more came for a while: an escape that stands alone is the key itself.
  void pause();
  /// The terminal is gone: Special::closed, after all keys before it.
  void close();

 private:
  std::string bytes_;
  std::deque<Key> keys_;

  std::size_t decode_one();
  std::size_t decode_escape();
};

}  // namespace breakshot::client
