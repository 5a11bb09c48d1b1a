#include "common/physics/timeline.hpp"
#include "common/record/bytes.hpp"
#include "common/record/describe_physics.hpp"
#include "common/record/record.hpp"

namespace breakshot::record {
namespace {

// What the digest is of, so that no other use of SHA-256 over bytes like these can collide with it.
constexpr std::string_view domain = "breakshot.simulate.1";

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
  return hash::sha256(std::move(writer).taken("the shot"));
}

}  // namespace breakshot::record
