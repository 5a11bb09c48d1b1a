// What came after the format was fixed: values without it keep their bytes, values with it have
// tags of their own, and no value has two encodings.
#include <gtest/gtest.h>

#include "common/record/bytes.hpp"
#include "common/record/describe_record.hpp"
#include "tests/record/fixed_record.hpp"

namespace breakshot::record {
namespace {

constexpr std::size_t f64 = 8;

template <class T>
ByteVector bytes_of(const T& value) {
  Writer writer;
  code(writer, value, 0);
  EXPECT_EQ(writer.damage(), std::nullopt);
  return writer.bytes();
}

/// The value that is read, or what is wrong.
template <class T>
std::variant<T, Damage> read(const ByteVector& bytes) {
  Reader reader(bytes);
  T value{};
  code(reader, value, 0);
  reader.end();
  if (reader.failed()) return *reader.damage();
  return value;
}

/// `plain` and `grown` differ by the tag at `tag_at` and by bytes at the end, and are read back.
template <class T>
void expect_growth(const T& plain, const T& grown, std::size_t tag_at, std::uint8_t tag) {
  const ByteVector before = bytes_of(plain), after = bytes_of(grown);
  ByteVector beginning(after.begin(), after.begin() + static_cast<std::ptrdiff_t>(before.size()));
  EXPECT_EQ(beginning[tag_at], tag);
  beginning[tag_at] = before[tag_at];
  EXPECT_EQ(beginning, before);
  EXPECT_EQ(read<T>(before), (std::variant<T, Damage>(plain)));
  EXPECT_EQ(read<T>(after), (std::variant<T, Damage>(grown)));
}

/// `bytes` with the new tag although nothing needs it.
template <class T>
std::string refusal_of(const T& plain, std::size_t tag_at, std::uint8_t tag, std::size_t zeros) {
  ByteVector bytes = bytes_of(plain);
  bytes[tag_at] = tag;
  bytes.resize(bytes.size() + zeros);
  const auto found = read<T>(bytes);
  return std::holds_alternative<Damage>(found) ? std::get<Damage>(found).what : "accepted";
}

physics::Segment sliding() {
  return {physics::BallId{3}, physics::Phase::slide, 0.5, {1, 2}, {3, 4}, {5, 6}};
}

TEST(Growth, ASegmentWithSpinHasAFormOfItsOwn) {
  const physics::Segment plain = sliding();
  physics::Segment spinning = plain;
  spinning.spin = {0, 0, 7};
  expect_growth(plain, spinning, 0, 1);
  EXPECT_EQ(bytes_of(spinning).size(), bytes_of(plain).size() + 6 * f64);
  spinning.spin = {};
  spinning.spin_change.x = -1;
  expect_growth(plain, spinning, 0, 1);
  EXPECT_EQ(refusal_of(plain, 0, 1, 6 * f64), "tag 1 spinning for a value that does not need it");
}

TEST(Growth, MinusZeroIsNoSpin) {
  physics::Segment segment = sliding();
  segment.spin = {-0.0, -0.0, -0.0};
  EXPECT_EQ(bytes_of(segment), bytes_of(sliding()));
}

TEST(Growth, AShotOffTheCentreIsACommandOfItsOwn) {
  const match::Shoot shoot{{0.6, -0.8}, 3.5, {physics::BallId{9}, physics::PocketId{4}, true}};
  match::Shoot off_centre = shoot;
  off_centre.tip = {0.25, -0.125};
  expect_growth(match::Command{shoot}, match::Command{off_centre}, 0, 7);
  EXPECT_EQ(bytes_of(match::Command{off_centre}).size(),
            bytes_of(match::Command{shoot}).size() + 2 * f64);
  EXPECT_EQ(refusal_of(match::Command{shoot}, 0, 7, 2 * f64),
            "tag 7 shoot_with_tip for a value that does not need it");
}

TEST(Growth, CushionsWithArcsHaveATagOfTheirOwn) {
  physics::FreeCushions segments;
  segments.segments.push_back({{1, -1}, {1, 1}, physics::Mirror{}});
  physics::FreeCushions both = segments;
  both.arcs.push_back({{2, 3}, 0.5, {1, 0}, {0, 1}, physics::Stronge2000{}});
  expect_growth(physics::Cushions{segments}, physics::Cushions{both}, 0, 2);
  EXPECT_EQ(refusal_of(physics::Cushions{segments}, 0, 2, 4),
            "tag 2 segments_and_arcs for a value that does not need it");
}

TEST(Growth, AnUnknownFormIsNamed) {
  ByteVector bytes = bytes_of(sliding());
  bytes[0] = 2;
  EXPECT_EQ(std::get<Damage>(read<physics::Segment>(bytes)),
            (Damage{0, "form: tag 2 is none of 0 plain, 1 spinning"}));
}

TEST(Growth, OneByteSaysWhichPocketsThereAre) {
  physics::Scene none = fixed_scene(), standard = none, jawed = none;
  none.pockets.reset();
  none.ball_ball.reset(), standard.ball_ball.reset(), jawed.ball_ball.reset();
  none.perturbation.reset(), standard.perturbation.reset(), jawed.perturbation.reset();
  jawed.pockets = physics::JawedPockets{};
  const std::size_t at = bytes_of(none).size() - 3;
  EXPECT_EQ(bytes_of(none)[at], 0);
  EXPECT_EQ(bytes_of(standard)[at], 1);
  EXPECT_EQ(bytes_of(standard).size(), bytes_of(none).size() + 2 * f64);
  EXPECT_EQ(bytes_of(jawed)[at], 2);
  EXPECT_EQ(bytes_of(jawed).size(), bytes_of(none).size() + 10 * f64);
  for (const physics::Scene& scene : {none, standard, jawed}) {
    EXPECT_EQ(read<physics::Scene>(bytes_of(scene)), (std::variant<physics::Scene, Damage>(scene)));
  }
  ByteVector bytes = bytes_of(none);
  bytes[at] = 3;
  EXPECT_EQ(std::get<Damage>(read<physics::Scene>(bytes)).what,
            "pockets: tag 3 is none of 0 absent, 1 standard, 2 jawed");
}

TEST(Growth, TheEndOfMovingInSpinIsEvent5) {
  const ByteVector bytes = bytes_of(physics::Event{physics::Spins{1.5, physics::BallId{3}}});
  EXPECT_EQ(bytes[0], 5);
  EXPECT_EQ(bytes.size(), 1 + f64 + 4);
}

}  // namespace
}  // namespace breakshot::record
