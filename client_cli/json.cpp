#include "client_cli/json.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace breakshot::client {

Json::Json(double value) : text_("null") {
  if (!std::isfinite(value)) return;
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0).ptr;
  text_.assign(buffer.data(), end);
}

Json::Json(std::string_view value) : text_("\"") {
  constexpr const char* digits = "0123456789abcdef";
  for (const char c : value) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      text_ += '\\';
      text_ += c;
    } else if (c == '\n') {
      text_ += "\\n";
    } else if (byte < 0x20) {
      text_ += "\\u00";
      text_ += digits[byte / 16];
      text_ += digits[byte % 16];
    } else {
      text_ += c;
    }
  }
  text_ += '"';
}

Json array(const std::vector<Json>& values) {
  Json json;
  json.text_ = "[";
  for (const Json& value : values) {
    if (json.text_.size() > 1) json.text_ += ',';
    json.text_ += value.text_;
  }
  json.text_ += ']';
  return json;
}

Json object(const std::vector<std::pair<std::string_view, Json>>& members) {
  Json json;
  json.text_ = "{";
  for (const auto& [key, value] : members) {
    if (json.text_.size() > 1) json.text_ += ',';
    json.text_ += Json(key).text_ + ':' + value.text_;
  }
  json.text_ += '}';
  return json;
}

}  // namespace breakshot::client
