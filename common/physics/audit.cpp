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
  Auditor(const Scene& scene, const Shot& shot, std::uint32_t physics)
      : scene_(scene), shot_(shot), laws_(scene, physics), balls_(Timeline(shot).balls()) {
    now_.resize(balls_.size());
    coordinates_.resize(balls_.size());
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
    const std::size_t ball = index_of(segment.ball);
    now_[ball] = segment;
    coordinates_[ball] = larger(coordinates_[ball], largest_coordinate(segment.position));
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

  /// A ball, and the largest coordinate from which it has come: no place on a path is more exact
  /// than where the path starts.
  struct Placed {
    Vec2 place;
    double coordinate_m;
  };

  void check_overlaps(double time_s) {
    std::vector<Placed> balls;
    for (std::size_t i = 0; i < now_.size(); ++i) {
      if (now_[i].phase == Phase::pocketed) continue;
      const Vec2 place = position_at(now_[i], time_s);
      balls.push_back({place, larger(coordinates_[i], largest_coordinate(place))});
    }
    for (const Placed& ball : balls) check_cushions(ball, time_s);
    if (!laws_.ball_ball) return;
    std::sort(balls.begin(), balls.end(),
              [](const Placed& a, const Placed& b) { return a.place.x < b.place.x; });
    for (std::size_t i = 0; i < balls.size(); ++i) {
      for (std::size_t j = i + 1; j < balls.size(); ++j) {
        const Vec2 between = balls[j].place - balls[i].place;
        if (between.x > laws_.diameter) break;
        deepen(laws_.diameter - length(between),
               larger(balls[i].coordinate_m, balls[j].coordinate_m), time_s);
      }
    }
  }

  /// Inside a rectangle no cushion line may be passed; any other cushion only counts where the
  /// ball's centre is in front of it.
  void check_cushions(const Placed& ball, double time_s) {
    const auto& [place, coordinate] = ball;
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
  std::vector<double> coordinates_;  ///< the largest that each ball has had, m
  double top_speed_ = 0;
  std::size_t segment_ = 0;
  std::size_t event_ = 0;
  Audit audit_;
};

}  // namespace

Audit audit(const Scene& scene, const Shot& shot, std::uint32_t physics) {
  return Auditor(scene, shot, physics).run();
}

}  // namespace breakshot::physics
