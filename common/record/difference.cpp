#include "common/record/difference.hpp"

#include <algorithm>
#include <charconv>

#include "common/record/describe_match.hpp"

namespace breakshot::record {
namespace {

struct Leaf {
  std::string path;
  std::string text;

  friend bool operator==(const Leaf&, const Leaf&) = default;
};

/// A codec that writes a value as text, a line a number, for people. How many elements a list has
/// is said after them: the first different element says more than the count.
class Lister : public Codec {
 public:
  static constexpr bool writing = true;

  void enter(std::string_view field) { path_.enter(field, 0); }
  void enter(std::size_t index) { path_.enter(index, 0); }

  template <class Number>
  void number(Number value) {
    char text[32];
    const auto end = std::to_chars(std::begin(text), std::end(text), value).ptr;
    leaf({text, end});
  }
  void choice(std::size_t& index, std::span<const Choice> choices) {
    leaf(std::string(choices[index].name));
  }
  void count(std::size_t&, std::size_t) {}
  void end_of_list(std::size_t count) { leaf(std::to_string(count) + " elements"); }
  void text(const std::string& value, std::size_t) { leaf('"' + value + '"'); }
  void raw(hash::Bytes bytes) { leaf(hash::hex_of(bytes)); }

  const std::vector<Leaf>& leaves() const { return leaves_; }

 private:
  void leaf(std::string text) { leaves_.push_back({path_.text(), std::move(text)}); }

  std::vector<Leaf> leaves_;
};

template <class Codec>
Codec described(const match::Outcome& outcome) {
  Codec codec;
  describe(codec, outcome);
  return codec;
}

}  // namespace

std::optional<std::string> difference_of(const match::Outcome& stored,
                                         const match::Outcome& simulated) {
  if (described<Writer>(stored).bytes() == described<Writer>(simulated).bytes()) {
    return std::nullopt;
  }
  const Lister ours = described<Lister>(stored), theirs = described<Lister>(simulated);
  // Neither list is a part of the other: each ends with a leaf that every outcome has.
  const auto [a, b] = std::mismatch(ours.leaves().begin(), ours.leaves().end(),
                                    theirs.leaves().begin(), theirs.leaves().end());
  const std::string named = a->path == b->path ? "" : b->path + ": ";
  return a->path + ": " + a->text + " stored, " + named + b->text + " simulated";
}

}  // namespace breakshot::record
