#include "common/physics/timeline.hpp"
#include "common/record/bytes.hpp"
#include "common/record/describe_physics.hpp"
#include "common/record/record.hpp"

namespace breakshot::record {
namespace {

// What the digest is of, so that no other use of SHA-256 over bytes like these can collide with it.
constexpr std::string_view domain = "breakshot.simulate.1";

/// A ball that still spins, or is rolling, at the end.
struct FinalSpin {
  physics::BallId ball{};
  physics::Vec3 spin;
};

template <class Codec>
void describe(Codec& c, Value<Codec, FinalSpin>& final_spin) {
  field(c, "ball", final_spin.ball);
  field(c, "spin", final_spin.spin);
}

std::vector<FinalSpin> spins_of(const std::vector<physics::BallState>& states) {
  std::vector<FinalSpin> spins;
  for (const physics::BallState& ball : states) {
    if (!(ball.spin == physics::Vec3{})) spins.push_back({ball.id, ball.spin});
  }
  return spins;
}

std::vector<physics::BallId> pocketed_in(const physics::Shot& shot) {
  std::vector<physics::BallId> pocketed;
  for (const physics::Event& event : shot.events) {
    if (const auto* drop = std::get_if<physics::BallPocket>(&event)) pocketed.push_back(drop->ball);
  }
  return pocketed;
}

}  // namespace

// A simulation outside a match may be longer than any that is recorded: nothing is limited here.
hash::Digest simulation_digest(const physics::Shot& shot) {
  Writer writer;
  writer.raw(hash::bytes_of(domain));
  field(writer, "events", shot.events, unlimited);
  field(writer, "end_s", shot.end_s);
  field(writer, "stop", shot.stop);
  const physics::Timeline timeline(shot);
  const std::vector<physics::BallState> states = timeline.states(timeline.end_s());
  field(writer, "final", states, unlimited);
  const std::vector<physics::BallId> pocketed = pocketed_in(shot);
  field(writer, "pocketed", pocketed, unlimited);
  // Spin came later: a shot that ends without any keeps its digest.
  const std::vector<FinalSpin> spins = spins_of(states);
  if (!spins.empty()) field(writer, "spins", spins, unlimited);
  return hash::sha256(std::move(writer).taken("the shot"));
}

}  // namespace breakshot::record
