// A slow reference beside the engine: after every event it looks at every ball, every pair and
// every cushion again, in long double. When things happen is worked out on its own
// (reference_crossing.hpp); what happens then, the laws of motion and of contacts, is the engine's
// code in the wider scalar. It knows no calendar and no reason to skip a pair but one: that both
// together cannot cover the gap.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "common/physics/resolve.hpp"
#include "common/physics/simulate.hpp"
#include "tests/support/reference_crossing.hpp"

namespace breakshot::support {

class ReferenceSimulation {
 public:
  using Vec = physics::BasicVec2<Wide>;
  using Path = physics::Path<Wide>;
  using Event = physics::BasicEvent<Wide>;
  using Segment = physics::BasicSegment<Wide>;

  /// The input must be free of faults. `last_s` bounds the time, `most` the events.
  ReferenceSimulation(const physics::Scene& scene, const physics::State& state,
                      const physics::ShotSeed& seed, Wide last_s, std::size_t most)
      : laws_(scene), contacts_(laws_, seed), last_s_(last_s), most_(most) {
    std::vector<physics::Ball> balls = state.balls;
    std::sort(balls.begin(), balls.end(),
              [](const physics::Ball& a, const physics::Ball& b) { return a.id < b.id; });
    for (const physics::Ball& ball : balls) {
      physics::Body<Wide> body;
      body.id = ball.id;
      body.position = physics::vec_of<Wide>(ball.position);
      body.velocity = physics::vec_of<Wide>(ball.velocity);
      body.spin = {Wide(ball.spin.x), Wide(ball.spin.y), Wide(ball.spin.z)};
      bodies_.push_back(body);
      paths_.push_back(laws_.cloth.path_from(ball.id, 0, body.position, body.moving()));
      segments.push_back(paths_.back().segment);
    }
  }

  /// To the end, or to the bounds. False if one instant never ended.
  bool run() {
    int here = 0;
    while (events.size() < most_) {
      const Wide next = earliest();
      if (!(next <= last_s_)) return true;
      here = next == now_s_ ? here + 1 : 0;
      if (here > 1'000) return false;
      if (!process(next, here > 0)) return false;
    }
    return true;
  }

  std::vector<Event> events;
  std::vector<Segment> segments;  ///< in order of time

 private:
  static constexpr Wide never = std::numeric_limits<Wide>::infinity();

  /// What one thing's motion relative to another is from now on.
  struct Meeting {
    Vec d, w, a;
    Wide end{};  ///< from now

    Vec at(Wide t) const { return d + (w + a * (t / 2)) * t; }
  };

  static Wide size(Vec v) { return std::sqrt(v.x * v.x + v.y * v.y); }

  /// What positions and velocities here and now cannot resolve, m.
  Wide blur(Vec position, Wide speed) const {
    const Wide coordinate = std::max({std::abs(position.x), std::abs(position.y), laws_.diameter});
    return 32 * std::numeric_limits<Wide>::epsilon() * (coordinate + speed * now_s_);
  }

  Wide left_of(const Path& path) const { return std::min(path.end_s, last_s_) - now_s_; }

  Meeting meeting(std::size_t i, const Path& other) const {
    const Segment& p = paths_[i].segment;
    const Segment& q = other.segment;
    return {physics::position_at(q, now_s_) - physics::position_at(p, now_s_),
            physics::velocity_at(q, now_s_) - physics::velocity_at(p, now_s_),
            q.acceleration - p.acceleration, std::min(left_of(paths_[i]), left_of(other))};
  }

  /// From now until the distance falls below `reach`, if it does before the end.
  Wide until_within(const Meeting& m, Wide reach, Wide blur) const {
    const Wide distance = size(m.d);
    const Wide gap = distance - reach;
    if (gap > size(m.w) * m.end + size(m.a) * m.end * m.end / 2 + blur) return never;
    // |d(t)|^2 - reach^2 in powers of t.
    const Quartic f{gap * (distance + reach), 2 * dot(m.d, m.w), dot(m.w, m.w) + dot(m.d, m.a),
                    dot(m.w, m.a), dot(m.a, m.a) / 4};
    if (gap > blur) {
      const auto t = FirstBelowZero(f, m.end).find([&](Wide s) { return size(m.at(s)) - reach; });
      return t ? *t : never;
    }
    // Touching: the factor t of f is divided out, and once more where nothing approaches or parts.
    const Wide still = 64 * std::numeric_limits<Wide>::epsilon() * speeds_ * distance;
    if (f[1] < -still) return 0;
    if (std::abs(f[1]) <= still) {
      if (f[2] <= 0 && m.a == Vec{}) return never;
      if (f[2] < 0) return 0;
      const Quartic twice{f[2], f[3], f[4], 0, 0};
      const auto t =
          FirstBelowZero(twice, m.end).find([&](Wide s) { return f[2] + (f[3] + f[4] * s) * s; });
      return t ? *t : never;
    }
    const Quartic once{f[1], f[2], f[3], f[4], 0};
    const auto t = FirstBelowZero(once, m.end).find([&](Wide s) {
      const Vec mean = m.w + m.a * (s / 2);
      return dot(mean, m.d * Wide(2) + mean * s);
    });
    return t ? *t : never;
  }

  Wide until_nose(std::size_t i, const physics::Nose<Wide>& nose) const {
    const Segment& s = paths_[i].segment;
    const Vec p = physics::position_at(s, now_s_) - nose.from;
    const Vec v = physics::velocity_at(s, now_s_);
    const Wide gap = dot(p, nose.inward) - laws_.radius;
    const Wide out = dot(v, nose.inward);
    const Wide pull = dot(s.acceleration, nose.inward);
    const Wide end = left_of(paths_[i]);
    const Wide blur = this->blur(p + nose.from, size(v));
    const auto within = [&](Wide t) {
      const Wide foot = dot(p + (v + s.acceleration * (t / 2)) * t, nose.along);
      return foot >= 0 && foot <= nose.extent;
    };
    // Every passage through the line towards the cushion; a ball behind it may come out first.
    Wide from = 0;
    if (std::abs(gap) <= blur) {
      const Wide still = 64 * std::numeric_limits<Wide>::epsilon() * speeds_;
      if (within(0) && (out < -still || (out <= still && pull < 0))) return 0;
      if (!(out > 0 && pull < 0)) return never;
      const Wide t = -2 * out / pull;
      return t <= end && within(t) ? t : never;
    }
    const auto height = [&](Wide t) { return gap + (out + pull * (t / 2)) * t; };
    if (gap < 0) {
      // Where it turns back, if it comes out until then.
      if (!(pull < 0) || !(out > 0)) return never;
      from = -out / pull;
      if (from > end || !(height(from) > 0)) return never;
    }
    const Quartic rest{height(from), out + pull * from, pull / 2, 0, 0};
    const auto t =
        FirstBelowZero(rest, end - from).find([&](Wide s2) { return height(from + s2); });
    return t && within(from + *t) ? from + *t : never;
  }

  static bool faces(const physics::Arc<Wide>& arc, Vec position) {
    const Vec d = position - arc.centre.segment.position;
    constexpr Wide slack = 1e-16L;
    return cross(arc.from, d) >= -slack && cross(d, arc.to) >= -slack &&
           dot(arc.from + arc.to, d) > 0;
  }

  Wide until_arc(std::size_t i, const physics::Arc<Wide>& arc) const {
    const Meeting m = meeting(i, arc.centre);
    const Segment& s = paths_[i].segment;
    const Vec p = physics::position_at(s, now_s_);
    const Wide t = until_within(m, arc.distance, blur(p, size(m.w)));
    return t < never && faces(arc, physics::position_at(s, now_s_ + t)) ? t : never;
  }

  enum class Kind { phase, pair, cushion, hole };
  struct Due {
    Wide time;
    Kind kind;
    std::uint32_t ball;
    std::uint32_t with;
  };

  void consider(Wide until, Kind kind, std::size_t ball, std::size_t with) {
    if (until == never) return;
    const Wide time = now_s_ + until;
    if (!due_.empty() && time > due_.front().time) return;
    if (!due_.empty() && time < due_.front().time) due_.clear();
    due_.push_back({time, kind, std::uint32_t(ball), std::uint32_t(with)});
  }

  /// Looks at everything; what is due first is left in due_.
  Wide earliest() {
    due_.clear();
    speeds_ = 0;
    for (const Path& path : paths_) speeds_ = std::max(speeds_, path.speed);
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      const Path& path = paths_[i];
      if (path.end_s < never) consider(path.end_s - now_s_, Kind::phase, i, 0);
      if (path.segment.phase == physics::Phase::pocketed) continue;
      if (laws_.ball_ball) meet_balls(i);
      if (physics::is_still(path.segment.phase)) continue;
      for (std::size_t k = 0; k < laws_.noses.size(); ++k) {
        consider(until_nose(i, laws_.noses[k]), Kind::cushion, i, k);
      }
      for (std::size_t k = 0; k < laws_.arcs.size(); ++k) {
        consider(until_arc(i, laws_.arcs[k]), Kind::cushion, i, laws_.noses.size() + k);
      }
      for (std::size_t k = 0; k < laws_.drops.size(); ++k) {
        const Meeting m = meeting(i, laws_.drops[k].centre);
        consider(until_within(m, laws_.drops[k].radius, blur(m.d, size(m.w))), Kind::hole, i, k);
      }
    }
    return due_.empty() ? never : due_.front().time;
  }

  void meet_balls(std::size_t i) {
    for (std::size_t j = i + 1; j < paths_.size(); ++j) {
      const physics::Phase p = paths_[i].segment.phase;
      const physics::Phase q = paths_[j].segment.phase;
      if (q == physics::Phase::pocketed) continue;
      if (physics::is_still(p) && physics::is_still(q)) continue;
      const Meeting m = meeting(i, paths_[j]);
      const Vec place = physics::position_at(paths_[i].segment, now_s_);
      consider(until_within(m, laws_.diameter, blur(place, size(m.w))), Kind::pair, i, j);
    }
  }

  struct AtPocket {
    std::uint32_t ball;
    Vec inward;
    physics::PocketId pocket;
  };

  bool process(Wide time, bool again) {
    now_s_ = time;
    touched_.clear();
    ended_.clear();
    at_pockets_.clear();
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      bodies_[i].position = physics::position_at(paths_[i].segment, time);
      bodies_[i].velocity = physics::velocity_at(paths_[i].segment, time);
      bodies_[i].spin = physics::spin_at(paths_[i].segment, time);
    }
    contacts_.begin(again ? contacts_.next_pass() : 0);
    if (!again) first_ = events.size();
    for (const Due& due : due_) take_up(due);
    const bool peace =
        contacts_.settle(bodies_, time, events, [this](std::uint32_t i) { add_touching(i); });
    for (const std::uint32_t ball : contacts_.balls()) touched_.push_back(ball);
    drop();
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (const std::uint32_t ball : touched_) renew(ball);
    std::sort(events.begin() + std::ptrdiff_t(first_), events.end(), physics::comes_before<Wide>);
    return peace;
  }

  void take_up(const Due& due) {
    touched_.push_back(due.ball);
    if (due.kind == Kind::pair) {
      contacts_.add_balls(bodies_, due.ball, due.with, true);
    } else if (due.kind == Kind::cushion) {
      meet_cushion(due.ball, due.with, true);
    } else if (due.kind == Kind::hole) {
      const physics::Drop<Wide>& hole = laws_.drops[due.with];
      at_pockets_.push_back(
          {due.ball, bodies_[due.ball].position - hole.centre.segment.position, hole.pocket});
    } else {
      end_phase(due.ball);
    }
  }

  void end_phase(std::uint32_t ball) {
    const Path path = laws_.cloth.path_after(paths_[ball]);
    bodies_[ball].velocity = path.segment.velocity;
    bodies_[ball].spin = path.segment.spin;
    ended_.push_back({ball, path});
    if (path.segment.phase == physics::Phase::rest) {
      events.push_back(physics::BasicRests<Wide>{now_s_, bodies_[ball].id});
    } else if (path.segment.phase == physics::Phase::spin) {
      events.push_back(physics::BasicSpins<Wide>{now_s_, bodies_[ball].id});
    } else {
      events.push_back(physics::BasicRolls<Wide>{now_s_, bodies_[ball].id});
    }
  }

  void meet_cushion(std::uint32_t ball, std::uint32_t cushion, bool predicted) {
    if (const auto pocket = laws_.pocket_at(cushion, bodies_[ball].position)) {
      at_pockets_.push_back({ball, laws_.noses[cushion].inward, *pocket});
      touched_.push_back(ball);
    } else {
      contacts_.add_cushion(bodies_, ball, cushion, predicted);
    }
  }

  void add_touching(std::uint32_t i) {
    const physics::Body<Wide>& body = bodies_[i];
    const Wide blur = this->blur(body.position, speeds_);
    for (std::uint32_t j = 0; laws_.ball_ball && j < bodies_.size(); ++j) {
      if (j == i || !bodies_[j].present || contacts_.has(i, j)) continue;
      if (size(bodies_[j].position - body.position) - laws_.diameter <= blur) {
        contacts_.add_balls(bodies_, i, j, false);
      }
    }
    std::uint32_t cushion = 0;
    for (const physics::Nose<Wide>& nose : laws_.noses) {
      const Wide gap = dot(body.position - nose.from, nose.inward) - laws_.radius;
      const Wide foot = dot(body.position - nose.from, nose.along);
      if (std::abs(gap) <= blur && foot >= 0 && foot <= nose.extent) {
        meet_cushion(i, cushion, false);
      }
      ++cushion;
    }
    for (const physics::Arc<Wide>& arc : laws_.arcs) {
      const Wide gap = size(body.position - arc.centre.segment.position) - arc.distance;
      if (gap <= blur && faces(arc, body.position)) meet_cushion(i, cushion, false);
      ++cushion;
    }
  }

  void drop() {
    const std::uint32_t pass = contacts_.next_pass() > 0 ? contacts_.next_pass() - 1 : 0;
    for (const AtPocket& at : at_pockets_) {
      physics::Body<Wide>& body = bodies_[at.ball];
      if (!body.present || !(dot(body.velocity, at.inward) < 0)) continue;
      events.push_back(physics::BasicBallPocket<Wide>{now_s_, pass, body.id, at.pocket});
      body.moving() = {};
      body.present = false;
    }
  }

  void renew(std::uint32_t ball) {
    const physics::Body<Wide>& body = bodies_[ball];
    Path path;
    if (!body.present) {
      path.segment = {body.id, physics::Phase::pocketed, now_s_, body.position, {}, {}, {}, {}};
    } else {
      path = laws_.cloth.path_from(body.id, now_s_, body.position, body.moving());
      for (const auto& [ended, after] : ended_) {
        const bool same =
            after.segment.velocity == body.velocity && after.segment.spin == body.spin;
        if (ended == ball && same) path = after;
      }
    }
    paths_[ball] = path;
    segments.push_back(path.segment);
  }

  physics::Laws<Wide> laws_;
  physics::ContactSet<Wide> contacts_;
  Wide last_s_;
  std::size_t most_;
  std::vector<physics::Body<Wide>> bodies_;
  std::vector<Path> paths_;
  Wide now_s_ = 0;
  Wide speeds_ = 0;  ///< the greatest of all balls
  std::vector<Due> due_;
  std::size_t first_ = 0;  ///< event of this instant
  std::vector<std::uint32_t> touched_;
  std::vector<std::pair<std::uint32_t, Path>> ended_;
  std::vector<AtPocket> at_pockets_;
};

}  // namespace breakshot::support
