// When things meet: closed forms, and the last bit where it decides.
#include "common/physics/detect.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "common/physics/angle.hpp"
#include "tests/support/scenes.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

constexpr double radius = 0.028575;
constexpr double diameter = 2 * radius;

Path<double> path(Vec2 position, Vec2 velocity, const Scene& scene, double start_s = 0) {
  return Cloth<double>(scene).path_from(BallId{0}, start_s, position, {velocity, {}});
}

double meet(const Scene& scene, Vec2 p, Vec2 v, Vec2 q, Vec2 w) {
  return contact_time(path(p, v, scene), path(q, w, scene), diameter, EntryFinder::quartics);
}

double next_up(double x) {
  return std::nextafter(x, 10.0);
}
double next_down(double x) {
  return std::nextafter(x, -10.0);
}

TEST(LinearContact, HasItsClosedForm) {
  EXPECT_NEAR(meet(gas(), {0, 0}, {2, 0}, {1, 0}, {0, 0}), (1 - diameter) / 2, 1e-16);
  EXPECT_NEAR(meet(gas(), {0, 0}, {2, 0}, {1, 0}, {-1, 0}), (1 - diameter) / 3, 1e-16);
  const double along = std::sqrt(diameter * diameter - 0.04 * 0.04);
  EXPECT_NEAR(meet(gas(), {0, 0.04}, {1, 0}, {1, 0}, {0, 0}), 1 - along, 4e-16);
  EXPECT_EQ(meet(gas(), {0, 0}, {-2, 0}, {1, 0}, {0, 0}), never<double>);
  EXPECT_EQ(meet(gas(), {0, 0}, {1, 1}, {1, 0}, {1, 1}), never<double>);
}

TEST(LinearContact, GrazesToOneUlp) {
  // Exactly a diameter beside the path is a tie, and a tie is a miss.
  for (const double x : {0.1, 0.5, 3.0, 1000.0}) {
    EXPECT_EQ(meet(gas(), {0, 0}, {1, 0}, {x, diameter}, {0, 0}), never<double>) << x;
    EXPECT_EQ(meet(gas(), {0, 0}, {1, 0}, {x, next_up(diameter)}, {0, 0}), never<double>) << x;
    EXPECT_NEAR(meet(gas(), {0, 0}, {1, 0}, {x, next_down(diameter)}, {0, 0}), x, 1e-8) << x;
  }
}

TEST(LinearContact, GrazesToOneUlpOnSlantedPaths) {
  // A 3-4-5 direction: the foot of the perpendicular is exact, so only the last bit decides.
  const Vec2 direction{0.6, 0.8};
  const Vec2 beside = perp(direction) * diameter;
  const long double tie = static_cast<long double>(direction.x) * beside.y -
                          static_cast<long double>(direction.y) * beside.x;
  const long double reach = static_cast<long double>(diameter) *
                            std::sqrt(static_cast<long double>(dot(direction, direction)));
  const bool hits = tie < reach;
  EXPECT_EQ(meet(gas(), {-0.6, -0.8}, direction, beside, {0, 0}) < never<double>, hits);
}

TEST(LinearContact, WorksAtTheSlowestAndTheFastestSpeeds) {
  EXPECT_NEAR(meet(gas(), {0, 0}, {1e-300, 0}, {1, 0}, {0, 0}) * 1e-300, 1 - diameter, 1e-15);
  EXPECT_EQ(meet(gas(), {0, 0}, {5e-324, 0}, {1, 0}, {0, 0}), never<double>);
  EXPECT_NEAR(meet(gas(), {0, 0}, {1e-200, 1e-201}, {1, 0.1}, {0, 0}) * 1e-200,
              1 - diameter / std::sqrt(1.01), 1e-15);
  EXPECT_NEAR(meet(gas(), {0, 0}, {1e4, 0}, {1, 0}, {0, 0}), (1 - diameter) / 1e4, 1e-20);
}

TEST(LinearContact, WorksForSlowBallsInTheShortestScalar) {
  const float far = 1 - static_cast<float>(diameter);
  for (const float speed : {1e-35f, 1e-12f, 1e-3f, 0.1f, 0.25f, 10.0f}) {
    Path<float> ball;
    ball.segment.phase = Phase::roll;
    ball.segment.velocity = {speed, 0};
    ball.speed = speed;
    Path<float> other;
    other.segment.position = {1, 0};
    EXPECT_NEAR(
        contact_time(ball, other, static_cast<float>(diameter), EntryFinder::quartics) * speed, far,
        1e-6f)
        << speed;
  }
}

TEST(DeceleratingContact, WithABallAtRestHasItsClosedForm) {
  const double a = 0.2 * 9.81;
  const double gap = 1 - diameter;
  const double t = (3 - std::sqrt(9 - 2 * a * gap)) / a;
  EXPECT_NEAR(meet(cloth(), {0, 0}, {3, 0}, {1, 0}, {0, 0}), t, 1e-15);
  EXPECT_NEAR(meet(cloth(), {1, 0}, {0, 0}, {0, 0}, {3, 0}), t, 1e-15);
}

TEST(DeceleratingContact, StopsShortByOneUnitOfTheGap) {
  // A roll of speed v covers v^2 / 2a. The gap is set to that, and 1e-14 m either side of it.
  const double v = 0.9;
  const double reach = v * v / (2 * 0.01 * 9.81);
  for (const double short_by : {1e-14, 3e-15}) {
    const Vec2 far{diameter + reach + short_by, 0};
    const Vec2 near{diameter + reach - short_by, 0};
    EXPECT_EQ(meet(cloth(), {0, 0}, {v, 0}, far, {0, 0}), never<double>) << short_by;
    EXPECT_LT(meet(cloth(), {0, 0}, {v, 0}, near, {0, 0}), never<double>) << short_by;
  }
}

TEST(QuarticContact, AgreesWithTheEquationInLongDouble) {
  Chance chance(3);
  int hits = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec2 p{chance.between(-1, 1), chance.between(-0.5, 0.5)};
    const Vec2 q{chance.between(-1, 1), chance.between(-0.5, 0.5)};
    if (length(q - p) < 1.01 * diameter) continue;
    const Vec2 v{chance.between(-4, 4), chance.between(-4, 4)};
    const Vec2 towards = (p - q) * chance.between(0.5, 6);
    const Vec2 w{towards.x + chance.between(-1, 1), towards.y + chance.between(-1, 1)};
    const Path<double> a = path(p, v, cloth());
    const Path<double> b = path(q, w, cloth());
    const double t = contact_time(a, b, diameter, EntryFinder::quartics);
    const auto gap = [&](long double time) {
      const auto at = [time](const Segment& s, double Vec2::*c) {
        return s.position.*c + (s.velocity.*c + s.acceleration.*c * (time / 2)) * time;
      };
      const long double dx = at(b.segment, &Vec2::x) - at(a.segment, &Vec2::x);
      const long double dy = at(b.segment, &Vec2::y) - at(a.segment, &Vec2::y);
      return std::sqrt(dx * dx + dy * dy) - static_cast<long double>(diameter);
    };
    const double end = std::min({a.end_s, b.end_s, 60.0});
    // Scan for an earlier entry than the one found.
    const double last = std::min(t, end);
    for (int k = 1; k < 200; ++k) {
      ASSERT_GT(gap(last * k / 200.0L), t < never<double> ? -1e-15L : 0.0L) << "case " << i;
    }
    if (t == never<double>) continue;
    ++hits;
    ASSERT_LE(t, end);
    ASSERT_NEAR(static_cast<double>(gap(t)), 0, 4e-15) << "case " << i;
  }
  EXPECT_GT(hits, 1000);
}

/// Two balls on bent paths that come nearest, to within `miss` diameters of a touch, at about
/// `time_s`; both phases end `after` seconds later.
std::array<Path<double>, 2> near_pass(Chance& chance, double miss, double time_s, double after) {
  std::array<Path<double>, 2> paths;
  for (Path<double>& p : paths) {
    p.speed = chance.between(0.05, 6);
    p.curved = true;
    p.end_s = time_s + after;
    p.segment.phase = Phase::slide;
    p.segment.velocity = direction_of(chance.between(-pi, pi)) * p.speed;
    p.segment.acceleration = direction_of(chance.between(-pi, pi)) * 1.962;
  }
  auto& [a, b] = paths;
  const Vec2 w = velocity_at(b.segment, time_s) - velocity_at(a.segment, time_s);
  const Vec2 beside = perp(w / length(w)) * (diameter * (1 + miss));
  b.segment.position = position_at(a.segment, time_s) + beside - position_at(b.segment, time_s);
  return paths;
}

TEST(EntryFinders, AgreeOnWhatMeetsAndWhen) {
  Chance chance(4);
  int hits = 0, misses = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double depth = std::pow(10.0, chance.between(-9, 0));
    const auto [a, b] = near_pass(chance, i % 2 == 0 ? -depth : depth, chance.between(0.01, 0.8),
                                  chance.between(0, 0.5));
    if (length(b.segment.position - a.segment.position) < 1.001 * diameter) continue;
    const double newton = contact_time(a, b, diameter, EntryFinder::newton);
    const double quartics = contact_time(a, b, diameter, EntryFinder::quartics);
    ASSERT_EQ(newton < never<double>, quartics < never<double>) << "case " << i;
    if (newton == never<double>) {
      ++misses;
      continue;
    }
    ++hits;
    // What rounds metres is met so much later or earlier; grazing paths hardly close.
    const Vec2 d = position_at(b.segment, newton) - position_at(a.segment, newton);
    const Vec2 w = velocity_at(b.segment, newton) - velocity_at(a.segment, newton);
    const double closing = -dot(d, w) / diameter;
    ASSERT_GT(closing, 0) << "case " << i;
    ASSERT_NEAR(newton, quartics, 1e-15 + 4e-15 / closing) << "case " << i;
  }
  EXPECT_GT(hits, 5000);
  EXPECT_GT(misses, 5000);
}

TEST(EntryFinders, KeepTheLastBitFromAfarOnNearlyStraightRelativePaths) {
  // Two balls that slide alike, as after the same cushion: seen from afar the discriminant cancels.
  Chance chance(6);
  int hits = 0;
  for (int i = 0; i < 5'000; ++i) {
    auto [a, b] = near_pass(chance, -chance.between(0.1, 1), chance.between(0.1, 0.8), 0.5);
    b.segment.acceleration = a.segment.acceleration + Vec2{0, chance.between(-1, 1) * 1e-16};
    if (length(b.segment.position - a.segment.position) < 5 * diameter) continue;
    const double t = contact_time(a, b, diameter, EntryFinder::quartics);
    const auto distant = [](const Path<double>& path) {
      const auto wide = [](Vec2 v) { return BasicVec2<long double>{v.x, v.y}; };
      Path<long double> p;
      p.segment = {path.segment.ball,
                   path.segment.phase,
                   0,
                   wide(path.segment.position),
                   wide(path.segment.velocity),
                   wide(path.segment.acceleration),
                   {},
                   {}};
      p.speed = path.speed;
      p.end_s = path.end_s;
      p.curved = path.curved;
      return p;
    };
    const long double exact =
        contact_time<long double>(distant(a), distant(b), diameter, EntryFinder::newton);
    ASSERT_EQ(t < never<double>, exact < never<long double>) << "case " << i;
    if (t == never<double>) continue;
    ++hits;
    const Vec2 d = position_at(b.segment, t) - position_at(a.segment, t);
    const Vec2 w = velocity_at(b.segment, t) - velocity_at(a.segment, t);
    const double closing = -dot(d, w) / diameter;
    // Two ulps of the time, and one of where the balls start, a few metres away at most.
    ASSERT_NEAR(static_cast<double>(exact - static_cast<long double>(t)), 0,
                4.5e-16 * t + 9e-16 / closing)
        << "case " << i;
  }
  EXPECT_GT(hits, 1000);
}

TEST(EntryFinders, KeepTheLastBitWhereASlowPassBendsRoundTheOtherBall) {
  // Seen from inside the guess is so poor that the terms which the parabola leaves out decide.
  struct Pass {
    Vec2 position, velocity, acceleration;
    double end_s;
    double exact_s;
  };
  const std::vector<Pass> passes = {{{-0.4330331969853817, -0.034973069729256484},
                                     {1.541348750389223, -0.3284624383577697},
                                     {-2.4322798790438833, 1.2108171839460138},
                                     0.7919218363259599,
                                     0.5438422870339851},
                                    {{-1.749048160600519, 0.2722776291962473},
                                     {3.245672352299729, -0.956298839546889},
                                     {-2.91803942759142, 1.2793669722893088},
                                     1.2396957639757634,
                                     1.0390184129450684}};
  for (const Pass& pass : passes) {
    Path<double> still, moving;
    still.end_s = moving.end_s = pass.end_s;
    still.segment.phase = moving.segment.phase = Phase::slide;
    moving.curved = true;
    moving.segment.position = pass.position;
    moving.segment.velocity = pass.velocity;
    moving.segment.acceleration = pass.acceleration;
    moving.speed = length(pass.velocity);
    for (const EntryFinder finder : {EntryFinder::newton, EntryFinder::quartics}) {
      EXPECT_NEAR(contact_time(still, moving, diameter, finder), pass.exact_s, 5e-15);
    }
  }
}

TEST(Contact, AfterTheTimeAskedForIsNotMissedBefore) {
  Chance chance(5);
  int late = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto pass =
        near_pass(chance, -chance.between(0, 1), chance.between(0.01, 0.8), chance.between(0, 0.5));
    const Path<double>& a = pass[0];
    const Path<double>& b = pass[1];
    const double t = contact_time(a, b, diameter, EntryFinder::quartics);
    if (t == never<double>) continue;
    const auto by = [&a, &b](double until_s) {
      return contact_time(a, b, diameter, EntryFinder::quartics, until_s);
    };
    ASSERT_EQ(by(t), t) << "case " << i;
    ASSERT_EQ(by(next_down(t)), t) << "case " << i << ": rounding may have made it late";
    ASSERT_EQ(by(2 * t), t) << "case " << i;
    late += by(t / 2) == never<double>;
  }
  EXPECT_GT(late, 5000);
}

TEST(Touching, ApproachingIsAtOnceAndSeparatingIsNever) {
  EXPECT_EQ(meet(gas(), {0, 0}, {1, 0}, {diameter, 0}, {0, 0}), 0);
  EXPECT_EQ(meet(gas(), {0, 0}, {-1, 0}, {diameter, 0}, {0, 0}), never<double>);
  EXPECT_EQ(meet(gas(), {0, 0}, {0, 1}, {diameter, 0}, {0, 0}), never<double>);
  const double overlapping = diameter * (1 - 1e-15);
  EXPECT_EQ(meet(gas(), {0, 0}, {1, 0}, {overlapping, 0}, {0, 0}), 0);
  EXPECT_EQ(meet(gas(), {0, 0}, {-1, 0}, {overlapping, 0}, {0, 0}), never<double>);
}

TEST(Touching, SeparatedBallsMeetAgainWhenTheGapHasOpenedAndClosed) {
  // The front ball leaves faster but slides; the one behind rolls and catches up before it stops.
  Scene scene = cloth();
  scene.bed.motion = Straight{0.2, 0.01, 1.0};
  const Path<double> behind = path({0, 0}, {0.999, 0}, scene);
  const Path<double> front = path({diameter, 0}, {1.2, 0}, scene);
  const double t = contact_time(behind, front, diameter, EntryFinder::quartics);
  // Both squared distances are equal when 0.201 t = (0.2 - 0.01) g t^2 / 2.
  const double closed_form = 2 * 0.201 / (0.19 * 9.81);
  if (closed_form <= front.end_s) {
    EXPECT_NEAR(t, closed_form, 1e-12);
  } else {
    EXPECT_EQ(t, never<double>);
  }
}

TEST(CushionContact, MeetsTheLineARadiusInward) {
  const Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  const Laws<double> laws(scene);
  const Path<double> ball = path({0, 0}, {2, 0}, scene);
  EXPECT_NEAR(cushion_time(ball, laws.noses[0], radius, 2.0, never<double>), (1.1684 - radius) / 2,
              1e-15);
  EXPECT_EQ(cushion_time(ball, laws.noses[1], radius, 2.0, never<double>), never<double>);
  EXPECT_EQ(cushion_time(ball, laws.noses[2], radius, 2.0, never<double>), never<double>);
}

TEST(CushionContact, OfADeceleratingBallHasItsClosedForm) {
  const Scene scene = table(Straight{0.2, 0.01, 0}, Mirror{}, Elastic{});
  const Laws<double> laws(scene);
  const double a = 0.2 * 9.81;
  const double gap = 0.5842 - radius;
  const Path<double> ball = path({0, 0}, {0, 3}, scene);
  EXPECT_NEAR(cushion_time(ball, laws.noses[1], radius, 3.0, never<double>),
              (3 - std::sqrt(9 - 2 * a * gap)) / a, 1e-15);
  const double just_short = std::sqrt(2 * a * gap) * (1 - 1e-14);
  EXPECT_EQ(
      cushion_time(path({0, 0}, {0, just_short}, scene), laws.noses[1], radius, 3.0, never<double>),
      never<double>);
}

TEST(CushionContact, EndsWithTheExtentOfTheCushion) {
  Scene scene = gas();
  scene.cushions = FreeCushions{{{{0, 1}, {-1, 1}, Mirror{}}}};
  const Laws<double> laws(scene);
  const auto time = [&](double x) {
    return cushion_time(path({x, 0}, {0, 1}, scene), laws.noses[0], radius, 1.0, never<double>);
  };
  EXPECT_EQ(time(1e-9), never<double>);
  EXPECT_NEAR(time(0), 1 - radius, 1e-15);
  EXPECT_NEAR(time(-1), 1 - radius, 1e-15);
  EXPECT_EQ(time(-1 - 1e-9), never<double>);
  // From behind, the cushion is not there.
  EXPECT_EQ(
      cushion_time(path({-0.5, 2}, {0, -1}, scene), laws.noses[0], radius, 1.0, never<double>),
      never<double>);
}

}  // namespace
}  // namespace breakshot::physics
