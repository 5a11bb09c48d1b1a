#include <algorithm>
#include <array>
#include <utility>

#include "common/physics/table.hpp"
#include "common/rules/eight_ball.hpp"

namespace breakshot::rules {
namespace {

using physics::BallId;

// Places of physics::triangle_rack, row by row from the apex.
constexpr std::size_t middle = 4;
constexpr std::size_t back_corner_right = 10;
constexpr std::size_t back_corner_left = 14;

/// Draws whole numbers without bias out of the rack stream of one rack.
class Draws {
 public:
  Draws(const physics::Seed& seed, std::uint32_t rack)
      : key_(key_of({seed, rack}, physics::Stream::rack)) {}

  /// Uniform in [0, bound): words in the incomplete last interval of the range are thrown away.
  std::size_t below(std::uint32_t bound) {
    const std::uint32_t excess = (0xffffffffU % bound + 1) % bound;
    for (;;) {
      const std::uint32_t word = next();
      if (word <= 0xffffffffU - excess) return word % bound;
    }
  }

 private:
  std::uint32_t next() {
    if (used_ == block_.size()) {
      block_ = physics::philox({blocks_++, 0, 0, 0}, key_);
      used_ = 0;
    }
    return block_[used_++];
  }

  physics::PhiloxKey key_;
  physics::PhiloxCounter block_{};
  std::size_t used_ = 4;
  std::uint32_t blocks_ = 0;
};

/// Takes the ball at `index` out of `balls`.
BallId take(std::vector<BallId>& balls, std::size_t index) {
  const BallId ball = balls[index];
  balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(index));
  return ball;
}

/// The ball at each place: every arrangement that WPA 3.2 allows is equally likely.
std::array<BallId, 15> arrangement(Draws draws) {
  std::vector<BallId> solids;
  std::vector<BallId> stripes;
  for (std::uint32_t i = 1; i <= 7; ++i) {
    solids.push_back(BallId{i});
    stripes.push_back(BallId{i + 8});
  }
  BallId right = take(solids, draws.below(7));
  BallId left = take(stripes, draws.below(7));
  if (draws.below(2) == 1) std::swap(right, left);

  std::vector<BallId> rest = std::move(solids);
  rest.insert(rest.end(), stripes.begin(), stripes.end());
  for (std::size_t i = rest.size() - 1; i > 0; --i) {
    std::swap(rest[i], rest[draws.below(static_cast<std::uint32_t>(i + 1))]);
  }

  std::array<BallId, 15> places{};
  for (std::size_t place = 0; place < places.size(); ++place) {
    switch (place) {
      case middle:
        places[place] = eight_ball_id;
        break;
      case back_corner_right:
        places[place] = right;
        break;
      case back_corner_left:
        places[place] = left;
        break;
      default:
        places[place] = take(rest, rest.size() - 1);
    }
  }
  return places;
}

}  // namespace

physics::State rack_eight_ball(const physics::Scene& scene, const physics::Seed& seed,
                               std::uint32_t rack) {
  const auto positions = triangle_rack(scene.bed, scene.ball, physics::rack_gap_m);
  const auto balls = arrangement(Draws(seed, rack));
  physics::State table;
  table.balls.push_back({cue_ball, head_spot(scene.bed), {}, {}});
  for (std::size_t i = 0; i < positions.size(); ++i) {
    table.balls.push_back({balls[i], positions[i], {}, {}});
  }
  std::sort(table.balls.begin(), table.balls.end(),
            [](const physics::Ball& a, const physics::Ball& b) { return a.id < b.id; });
  return table;
}

}  // namespace breakshot::rules
