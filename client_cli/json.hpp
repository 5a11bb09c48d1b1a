// Writing JSON (RFC 8259): values that are already text, put together in the order given.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace breakshot::client {

/// One JSON value, written out on one line without spaces.
class Json {
 public:
  // NOLINTBEGIN(google-explicit-constructor): values stand where JSON is expected.
  Json() : text_("null") {}
  Json(bool value) : text_(value ? "true" : "false") {}
  template <std::integral Integer>
  Json(Integer value) : text_(std::to_string(value)) {}
  /// The shortest number that reads back to the same bits, -0 as 0; infinities and NaN, for which
  /// JSON has no word, are null.
  Json(double value);
  Json(std::string_view value);
  Json(const std::string& value) : Json(std::string_view(value)) {}
  Json(const char* value) : Json(std::string_view(value)) {}
  template <class Value>
  Json(const std::optional<Value>& value) : Json(value ? Json(*value) : Json()) {}
  // NOLINTEND(google-explicit-constructor)

  const std::string& text() const { return text_; }

  friend Json array(const std::vector<Json>& values);
  friend Json object(const std::vector<std::pair<std::string_view, Json>>& members);

 private:
  std::string text_;
};

Json array(const std::vector<Json>& values);
Json object(const std::vector<std::pair<std::string_view, Json>>& members);

/// An array with one element for each of `values`, made by `json_of`.
template <class Values, class Make>
Json array_of(const Values& values, const Make& json_of) {
  std::vector<Json> all;
  for (const auto& value : values) all.push_back(json_of(value));
  return array(all);
}

}  // namespace breakshot::client
