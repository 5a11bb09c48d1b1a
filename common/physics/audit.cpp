#include "common/physics/audit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/physics/resolve.hpp"
#include "common/physics/timeline.hpp"

namespace breakshot::physics {
namespace {

/// Follows a shot from instant to instant.
class Auditor {
 public:
  Auditor(const Scene& scene, const Shot& shot)
      : scene_(scene), shot_(shot), laws_(scene), balls_(Timeline(shot).balls()) {
    now_.resize(balls_.size());
  }

  Audit run() {
    while (segment_ < shot_.segments.size() && shot_.segments[segment_].start_s == 0) take();
    audit_.energy_start_J = energy(0);
    top_speed_ = std::sqrt(2 * audit_.energy_start_J / scene_.ball.mass_kg);
    check_overlaps(0);
    skip_events(0);
    while (segment_ < shot_.segments.size()) {
      const double t = shot_.segments[segment_].start_s;
      const std::vector<Segment> before = now_;
      const double energy_before = energy(t);
      while (segment_ < shot_.segments.size() && shot_.segments[segment_].start_s == t) take();
      const double rise = energy(t) - energy_before - allowed(t, before);
      audit_.worst_rise_J = std::max(audit_.worst_rise_J, rise);
      check_overlaps(t);
    }
    audit_.energy_end_J = energy(shot_.end_s);
    return audit_;
  }

 private:
  std::size_t index_of(BallId ball) const {
    return static_cast<std::size_t>(std::lower_bound(balls_.begin(), balls_.end(), ball) -
                                    balls_.begin());
  }

  void take() {
    const Segment& segment = shot_.segments[segment_++];
    now_[index_of(segment.ball)] = segment;
  }

  void skip_events(double time_s) {
    while (event_ < shot_.events.size() && time_of(shot_.events[event_]) == time_s) ++event_;
  }

  double energy(double time_s) const {
    double sum = 0;
    for (const Segment& segment : now_) {
      const Vec2 velocity = velocity_at(segment, time_s);
      const Vec3 spin = spin_at(segment, time_s);
      sum += dot(velocity, velocity) + 0.4 * laws_.radius * laws_.radius * dot(spin, spin);
    }
    return scene_.ball.mass_kg / 2 * sum;
  }

  /// What resting contacts may add at this instant: one allowance for each contact that hardly
  /// approached before it, and for each later pass, whose approaches the record does not hold.
  double allowed(double time_s, const std::vector<Segment>& before) {
    double sum = 0;
    for (; event_ < shot_.events.size() && time_of(shot_.events[event_]) == time_s; ++event_) {
      if (std::holds_alternative<BallCushion>(shot_.events[event_])) sum += allowed_at_cushion();
      const auto* contact = std::get_if<BallBall>(&shot_.events[event_]);
      if (contact == nullptr || !laws_.ball_ball) continue;
      const Segment& a = before[index_of(contact->lower)];
      const Segment& b = before[index_of(contact->higher)];
      const Vec2 between = position_at(b, time_s) - position_at(a, time_s);
      const Vec2 velocity = velocity_at(b, time_s) - velocity_at(a, time_s);
      const double approach = -dot(between, velocity) / length(between);
      const double apart = laws_.hop_of(laws_.ball_ball->bounce);
      if (contact->pass == 0 && approach > laws_.resting_share * apart) continue;
      sum += scene_.ball.mass_kg * apart * apart / 4;
    }
    return sum;
  }

  /// A ball may rest against a cushion, that it slows down from or that its spin pushes it to.
  double allowed_at_cushion() const {
    double apart = 0;
    for (const NoseResponse<double>& nose : laws_.responses) {
      apart = std::max(apart, laws_.hop_of(nose.bounce));
    }
    return scene_.ball.mass_kg * apart * apart / 2;
  }

  void check_overlaps(double time_s) {
    std::vector<Vec2> places;
    for (const Segment& segment : now_) {
      if (segment.phase != Phase::pocketed) places.push_back(position_at(segment, time_s));
    }
    for (const Vec2 place : places) check_cushions(place, time_s);
    if (!laws_.ball_ball) return;
    std::sort(places.begin(), places.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = i + 1; j < places.size(); ++j) {
        if (places[j].x - places[i].x > laws_.diameter) break;
        deepen(laws_.diameter - length(places[j] - places[i]),
               larger(largest_coordinate(places[i]), largest_coordinate(places[j])), time_s);
      }
    }
  }

  /// Inside a rectangle no cushion line may be passed; any other cushion only counts where the
  /// ball's centre is in front of it.
  void check_cushions(Vec2 place, double time_s) {
    const double coordinate = largest_coordinate(place);
    const bool enclosed = laws_.inside && laws_.drops.empty();
    for (const Nose<double>& nose : laws_.noses) {
      const Vec2 offset = place - nose.from;
      const double distance = dot(offset, nose.inward);
      const double foot = dot(offset, nose.along);
      const bool in_front = distance >= 0 && foot >= 0 && foot <= nose.extent;
      if (enclosed || in_front) deepen(laws_.radius - distance, coordinate, time_s);
    }
    for (const Arc<double>& arc : laws_.arcs) {
      if (!faces(arc, place)) continue;
      deepen(arc.distance - length(place - arc.centre.segment.position),
             larger(coordinate, arc.distance), time_s);
    }
  }

  void deepen(double overlap_m, double coordinate_m, double time_s) {
    const double explained =
        8 * ulp(larger(coordinate_m, laws_.diameter)) + 2 * top_speed_ * ulp(time_s);
    audit_.worst_penetration_m = std::max(audit_.worst_penetration_m, overlap_m);
    audit_.worst_excess_m = std::max(audit_.worst_excess_m, overlap_m - explained);
  }

  const Scene& scene_;
  const Shot& shot_;
  Laws<double> laws_;
  std::vector<BallId> balls_;
  std::vector<Segment> now_;
  double top_speed_ = 0;
  std::size_t segment_ = 0;
  std::size_t event_ = 0;
  Audit audit_;
};

}  // namespace

Audit audit(const Scene& scene, const Shot& shot) {
  return Auditor(scene, shot).run();
}

}  // namespace breakshot::physics
