// From the alphabet to C++'s types: how a field, a list, an optional, an enumeration or a variant
// is encoded, for every codec. A structure is encoded by its overload of `describe`, field by
// field.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "common/record/bytes.hpp"

namespace breakshot::record {

/// What a description takes: a value to be read into, or a constant one.
template <class Codec, class T>
using Value = std::conditional_t<Codec::writing, const T, T>;

/// Ids are numbers of any value; other enumerations are closed and have `Names`.
template <class T>
inline constexpr bool is_id = false;

/// `all`: the names of an enumeration's members, from 0 upwards. A member's number is its tag.
template <class Enum>
struct Names;

/// Tag and name of an alternative of a variant. The order of alternatives in C++ may change; tags
/// never do.
template <class Alternative>
inline constexpr Choice tag_of{};

/// How a type has grown since its encoding was fixed: values that have nothing of what is new keep
/// their bytes, others have a tag of their own and, after the old fields, those that
/// `describe_growth` names. `needed` says which values these are: each has one encoding.
template <class T>
struct Growth {
  static constexpr Choice tag{};
  static bool needed(const T&) { return false; }
};

template <class Codec, class T>
void code(Codec& codec, T& value, std::size_t limit);

/// One named field. Lists and text must have a limit.
template <class Codec, class T>
void field(Codec& codec, std::string_view name, T& value, std::size_t limit = 0) {
  codec.enter(name);
  code(codec, value, limit);
  codec.leave();
}

/// A number that has only this value so far.
template <class Codec, std::integral Number>
void fixed(Codec& codec, std::string_view name, Number only) {
  Value<Codec, Number> value = only;
  codec.enter(name);
  codec.number(value);
  codec.rule([&]() -> std::optional<std::string> {
    if (value == only) return std::nullopt;
    return std::to_string(value) + " found, only " + std::to_string(only) + " is known";
  });
  codec.leave();
}

template <class T>
inline constexpr bool grows = !Growth<T>::tag.name.empty();

/// The fields by which a value has grown.
template <class Codec, class T>
void growth(Codec& codec, T& value) {
  describe_growth(codec, value);
  codec.rule([&]() -> std::optional<std::string> {
    using Plain = std::remove_const_t<T>;
    if (Growth<Plain>::needed(value)) return std::nullopt;
    return "tag " + std::to_string(Growth<Plain>::tag.tag) + ' ' +
           std::string(Growth<Plain>::tag.name) + " for a value that does not need it";
  });
}

/// The form of a structure that has grown: 0 as it was at first, or the tag of its growth. Says
/// whether `growth` is to follow the old fields.
template <class Codec, class T>
bool form(Codec& codec, std::string_view name, T& value) {
  using Grown = Growth<std::remove_const_t<T>>;
  static constexpr std::array choices{Choice{0, "plain"}, Grown::tag};
  std::size_t index = Grown::needed(value) ? 1 : 0;
  codec.enter(name);
  codec.choice(index, choices);
  codec.leave();
  return index == 1;
}

namespace detail {

template <std::size_t N>
constexpr std::array<Choice, N> choices_of(const std::array<std::string_view, N>& names) {
  std::array<Choice, N> choices{};
  for (std::size_t i = 0; i < N; ++i) choices[i] = {static_cast<std::uint8_t>(i), names[i]};
  return choices;
}

template <class Codec, class Enum>
void code_enum(Codec& codec, Enum& value) {
  static constexpr auto choices = choices_of(Names<std::remove_const_t<Enum>>::all);
  auto index = static_cast<std::size_t>(value);
  codec.choice(index, choices);
  if constexpr (!Codec::writing) value = static_cast<Enum>(index);
}

template <class Codec, class Id>
void code_id(Codec& codec, Id& value) {
  auto number = static_cast<std::underlying_type_t<std::remove_const_t<Id>>>(value);
  codec.number(number);
  if constexpr (!Codec::writing) value = static_cast<Id>(number);
}

template <class Codec, class Bool>
void code_bool(Codec& codec, Bool& value) {
  static constexpr std::array choices{Choice{0, "no"}, Choice{1, "yes"}};
  std::size_t index = value ? 1 : 0;
  codec.choice(index, choices);
  if constexpr (!Codec::writing) value = index == 1;
}

template <class Codec, class Optional>
void code_optional(Codec& codec, Optional& value, std::size_t limit) {
  static constexpr std::array choices{Choice{0, "absent"}, Choice{1, "present"}};
  std::size_t present = value ? 1 : 0;
  codec.choice(present, choices);
  if constexpr (!Codec::writing) {
    value.reset();
    if (present == 1) value.emplace();
  }
  if (value) code(codec, *value, limit);
}

// The list grows as its elements are found: a false count cannot make it allocate much more than
// there are bytes.
template <class Codec, class Vector>
void code_vector(Codec& codec, Vector& value, std::size_t limit) {
  std::size_t count = value.size();
  codec.count(count, limit);
  if constexpr (!Codec::writing) value.clear();
  for (std::size_t i = 0; i < count && !codec.failed(); ++i) {
    codec.enter(i);
    if constexpr (Codec::writing) {
      // Named by its type: some libraries give a stand-in for an element of std::vector<bool>.
      const typename Vector::value_type& element = value[i];
      code(codec, element, 0);
    } else {
      typename Vector::value_type element{};
      code(codec, element, 0);
      value.push_back(std::move(element));
    }
    codec.leave();
  }
  codec.end_of_list(count);
}

/// The tags of a variant: one for each alternative, then one for each that has grown.
template <class... Alternatives>
struct Tags {
  static_assert((!tag_of<Alternatives>.name.empty() && ...), "every alternative needs its tag");
  static constexpr std::size_t plain = sizeof...(Alternatives);
  static constexpr std::size_t count = (plain + ... + std::size_t{grows<Alternatives>});

  std::array<Choice, count> choices{tag_of<Alternatives>...};
  std::array<std::size_t, count> alternative{};  ///< that a tag is of
  std::array<std::size_t, plain> grown{};        ///< the place of its second tag, where it has one

  constexpr Tags() {
    std::size_t index = 0, next = plain;
    (add<Alternatives>(index++, next), ...);
  }

 private:
  template <class Alternative>
  constexpr void add(std::size_t index, std::size_t& next) {
    alternative[index] = index;
    if (!grows<Alternative>) return;
    choices[next] = Growth<Alternative>::tag;
    alternative[next] = index;
    grown[index] = next++;
  }
};

template <class Codec, class T, class... Alternatives>
void code_variant(Codec& codec, T& value, std::type_identity<std::variant<Alternatives...>>) {
  static constexpr Tags<Alternatives...> tags;
  const auto has_grown = [](const auto& alternative) {
    return Growth<std::decay_t<decltype(alternative)>>::needed(alternative);
  };
  std::size_t index = value.index();
  if (std::visit(has_grown, value)) index = tags.grown[index];
  codec.choice(index, tags.choices);
  if constexpr (!Codec::writing) {
    using Variant = std::variant<Alternatives...>;
    using Make = Variant (*)();
    static constexpr std::array<Make, sizeof...(Alternatives)> make{
        +[]() -> Variant { return Alternatives{}; }...};
    value = make[tags.alternative[index]]();
  }
  std::visit(
      [&](auto& alternative) {
        code(codec, alternative, 0);
        if constexpr (grows<std::decay_t<decltype(alternative)>>) {
          if (index >= tags.plain) growth(codec, alternative);
        }
      },
      value);
}

template <class T>
struct Kind {
  static constexpr bool optional = false, vector = false, variant = false, bytes = false;
};
template <class T>
struct Kind<std::optional<T>> : Kind<void> {
  static constexpr bool optional = true;
};
template <class T>
struct Kind<std::vector<T>> : Kind<void> {
  static constexpr bool vector = true;
};
template <class... Alternatives>
struct Kind<std::variant<Alternatives...>> : Kind<void> {
  static constexpr bool variant = true;
};
template <std::size_t N>
struct Kind<std::array<std::uint8_t, N>> : Kind<void> {
  static constexpr bool bytes = true;
};

}  // namespace detail

template <class Codec, class T>
void code(Codec& codec, T& value, std::size_t limit) {
  using Plain = std::remove_const_t<T>;
  if constexpr (std::is_same_v<Plain, bool>) {
    detail::code_bool(codec, value);
  } else if constexpr (std::is_arithmetic_v<Plain>) {
    codec.number(value);
  } else if constexpr (is_id<Plain>) {
    detail::code_id(codec, value);
  } else if constexpr (std::is_enum_v<Plain>) {
    detail::code_enum(codec, value);
  } else if constexpr (std::is_same_v<Plain, std::string>) {
    codec.text(value, limit);
  } else if constexpr (detail::Kind<Plain>::bytes) {
    codec.raw(value);
  } else if constexpr (detail::Kind<Plain>::optional) {
    detail::code_optional(codec, value, limit);
  } else if constexpr (detail::Kind<Plain>::vector) {
    detail::code_vector(codec, value, limit);
  } else if constexpr (detail::Kind<Plain>::variant) {
    detail::code_variant(codec, value, std::type_identity<Plain>{});
  } else {
    describe(codec, value);
  }
}

}  // namespace breakshot::record
