// From one instant with events to the next, for any scalar and either calendar. However a caller
// slices the advance, the shot has the same bits: nothing is written between events.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/physics/appointment.hpp"
#include "common/physics/event.hpp"
#include "common/physics/hand.hpp"
#include "common/physics/resolve.hpp"
#include "common/physics/simulate.hpp"
#include "common/physics/touching.hpp"

namespace breakshot::physics {

/// Sets that may follow one another at one instant, beyond which the shot is stalled: contacts that
/// neither part nor let time pass.
inline constexpr std::uint32_t max_sets_at_an_instant = 1'000;

enum class Progress : std::uint8_t { paused, finished, stalled };

/// The loop with one of the calendars.
template <class Real, template <class> class Calendar>
class Loop {
 public:
  Loop(const Scene& scene, const State& state, const std::optional<Strike>& strike,
       const ShotSeed& seed, const Limits& limits)
      : laws_(scene, limits.physics),
        limits_(limits),
        calendar_(laws_, top_speed_of(state, strike), state.balls.size()),
        contacts_(laws_, seed),
        collisions_(laws_.perturbs() ? state.balls.size() : 0),
        hand_(state.balls.size()) {
    place(state, strike);
  }

  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  Progress advance_to(Real time_s) {
    const Real horizon = limits_.horizon_s ? Real(*limits_.horizon_s) : never<Real>;
    while (progress_ == Progress::paused) {
      const Real next = calendar_.earliest(smaller(time_s, horizon));
      if (next > horizon || next == never<Real>) {
        if (time_s < horizon && (calendar_.moving() || next < never<Real>)) return progress_;
        finish(horizon);
      } else if (next > time_s) {
        return progress_;
      } else if (forgotten_events_ + shot_.events.size() >= limits_.max_events) {
        stall(StallCause::events);
      } else {
        process(next);
      }
    }
    return progress_;
  }

  /// For calendars that are to be told more before the first advance.
  Calendar<Real>& calendar() { return calendar_; }

  const BasicShot<Real>& shot() const { return shot_; }

  void forget() {
    forgotten_events_ += shot_.events.size();
    shot_.events.clear();
    shot_.segments.clear();
  }

  std::variant<BasicShot<Real>, BasicStalled<Real>> take() && {
    if (progress_ != Progress::stalled) return std::move(shot_);
    std::vector<BallId> last;
    for (const std::uint32_t ball : touched_) last.push_back(hand_.of(ball).id);
    return BasicStalled<Real>{cause_, std::move(last), std::move(shot_)};
  }

 private:
  using Vec = BasicVec2<Real>;

  /// No ball can ever be faster than all energy in one ball makes it, give or take weak contacts.
  static Real top_speed_of(const State& state, const std::optional<Strike>& strike) {
    Real squares = 1;
    for (const Ball& ball : state.balls) {
      const Vec velocity{Real(ball.velocity.x), Real(ball.velocity.y)};
      squares += dot(velocity, velocity);
    }
    if (strike) squares += Real(strike->speed_m_s) * Real(strike->speed_m_s);
    using std::sqrt;
    return sqrt(squares);
  }

  void place(const State& state, const std::optional<Strike>& strike) {
    std::vector<Ball> balls = state.balls;
    std::sort(balls.begin(), balls.end(), [](const Ball& a, const Ball& b) { return a.id < b.id; });
    shot_.segments.reserve(8 * balls.size() + 64);
    shot_.events.reserve(256);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      Moving<Real> moving{vec_of<Real>(balls[i].velocity),
                          {Real(balls[i].spin.x), Real(balls[i].spin.y), Real(balls[i].spin.z)}};
      if (strike && strike->ball == balls[i].id) {
        moving = struck(*strike);
        shot_.events.push_back(BasicStruck<Real>{Real(0), strike->ball});
      }
      const Path<Real> path =
          laws_.cloth.path_from(balls[i].id, Real(0), vec_of<Real>(balls[i].position), moving);
      calendar_.set(static_cast<std::uint32_t>(i), path);
      shot_.segments.push_back(path.segment);
    }
    calendar_.update();
  }

  /// The stroke of a level cue as an impulse at the tip's place on the ball: what speed it gives,
  /// it turns the ball by, times 5/2 of the offset.
  Moving<Real> struck(const Strike& strike) const {
    const Vec wanted = vec_of<Real>(strike.direction);
    const Vec direction = wanted / length(wanted);
    const Real speed = Real(strike.speed_m_s);
    const Real turning = 5 * speed / (2 * laws_.radius);
    const Vec follow = perp(direction) * (turning * Real(strike.tip.height));
    return {direction * speed, {follow.x, follow.y, -turning * Real(strike.tip.side)}};
  }

  /// The place among the bodies of a ball, as it is now.
  std::uint32_t at_hand(std::uint32_t ball) {
    const std::uint32_t place = hand_.find(ball);
    return place == hand_.nowhere ? take_to_hand(ball) : place;
  }

  std::uint32_t take_to_hand(std::uint32_t ball) {
    const auto& segment = calendar_.path(ball).segment;
    const std::uint32_t place = hand_.take(ball);
    Body<Real>& body = hand_[place];
    body.id = segment.ball;
    if (!collisions_.empty()) body.collisions = collisions_[ball];
    body.present = segment.phase != Phase::pocketed;
    body.touched = false;
    body.position = position_at(segment, now_s_);
    body.velocity = velocity_at(segment, now_s_);
    if (laws_.cloth.spins()) body.spin = spin_at(segment, now_s_);
    return place;
  }

  void finish(Real horizon) {
    progress_ = Progress::finished;
    const bool still = !calendar_.moving();
    shot_.stop = still ? Stop::rest : Stop::horizon;
    shot_.end_s = still ? now_s_ : horizon;
  }

  void stall(StallCause cause) {
    progress_ = Progress::stalled;
    cause_ = cause;
    shot_.end_s = now_s_;
  }

  /// Everything that happens at one instant: phases that end, then contacts as a set, then pockets.
  void process(Real time_s) {
    begin_instant(time_s);
    calendar_.each_due(time_s, [this](std::uint32_t ball, const Appointment<Real>& appointment) {
      take_up(ball, appointment);
    });
    const bool peace = contacts_.settle(hand_.bodies(), time_s, shot_.events,
                                        [this](std::uint32_t ball) { add_touching(ball); });
    for (const std::uint32_t place : contacts_.balls()) touch(place);
    if (!at_pockets_.empty()) drop_balls();
    end_instant();
    if (!peace || sets_here_ >= max_sets_at_an_instant) {
      stall(peace ? StallCause::instant : StallCause::passes);
    }
  }

  void begin_instant(Real time_s) {
    const bool again = time_s == now_s_ && sets_here_ > 0;
    sets_here_ = again ? sets_here_ + 1 : 1;
    if (!again) {
      first_event_ = time_s == 0 ? 0 : shot_.events.size();
      first_segment_ = time_s == 0 ? 0 : shot_.segments.size();
    }
    now_s_ = time_s;
    hand_.clear();
    calendar_.move_to(time_s);
    contacts_.begin(again ? contacts_.next_pass() : 0);
    touched_.clear();
    ended_.clear();
    at_pockets_.clear();
  }

  /// An appointment has come.
  void take_up(std::uint32_t ball, const Appointment<Real>& appointment) {
    const std::uint32_t place = at_hand(ball);
    if (appointment.due == Due::ball) {
      const std::uint32_t other = at_hand(appointment.with);
      if (!contacts_.has(place, other)) contacts_.add_balls(hand_.bodies(), place, other, true);
    } else if (appointment.due == Due::cushion) {
      meet_cushion(place, appointment.with, true);
    } else if (appointment.due == Due::hole) {
      const Drop<Real>& drop = laws_.drops[appointment.with];
      at_pockets_.push_back(
          {place, hand_[place].position - drop.centre.segment.position, drop.pocket});
      touch(place);
    } else {
      end_phase(place);
    }
  }

  void end_phase(std::uint32_t place) {
    Body<Real>& body = hand_[place];
    const Path<Real> path = laws_.cloth.path_after(calendar_.path(body.ball));
    body.velocity = path.segment.velocity;
    body.spin = path.segment.spin;
    ended_.push_back({body.ball, path});
    if (path.segment.phase == Phase::rest) {
      shot_.events.push_back(BasicRests<Real>{now_s_, body.id});
    } else if (path.segment.phase == Phase::spin) {
      shot_.events.push_back(BasicSpins<Real>{now_s_, body.id});
    } else {
      shot_.events.push_back(BasicRolls<Real>{now_s_, body.id});
    }
    touch(place);
  }

  /// `cushion` counts the arcs after the noses.
  void meet_cushion(std::uint32_t place, std::uint32_t cushion, bool predicted) {
    const auto pocket = laws_.pocket_at(cushion, hand_[place].position);
    if (pocket) {
      at_pockets_.push_back({place, laws_.noses[cushion].inward, *pocket});
      touch(place);
    } else {
      contacts_.add_cushion(hand_.bodies(), place, cushion, predicted);
    }
  }

  /// Adds all contacts of a ball that touch at this instant. Most gaps are far beyond the bound of
  /// any tolerance, and are not looked at twice.
  void add_touching(std::uint32_t place) {
    const Body<Real>& body = hand_[place];
    const Real coordinate = larger(laws_.diameter, largest_coordinate(body.position));
    const Real doubt = touch_gap_bound(2 * coordinate, 2 * calendar_.top_speed(), now_s_);
    const Real reach = laws_.diameter + 2 * doubt;
    if (laws_.ball_ball) {
      calendar_.each_near(body.ball, reach, [&](std::uint32_t ball) {
        const std::uint32_t other = at_hand(ball);
        if (contacts_.has(place, other) || !hand_[other].present) return;
        if (balls_touch(body, hand_[other], laws_.diameter, now_s_)) {
          contacts_.add_balls(hand_.bodies(), place, other, false);
        }
      });
    }
    if (laws_.is_inside(body.position, doubt)) return;
    std::uint32_t cushion = 0;
    for (const Nose<Real>& nose : laws_.noses) {
      const Real gap = dot(body.position - nose.from, nose.inward) - laws_.radius;
      if (gap <= doubt &&
          nose_touches(body, nose, gap, laws_.radius, calendar_.top_speed(), now_s_))
        meet_cushion(place, cushion, false);
      ++cushion;
    }
    for (const Arc<Real>& arc : laws_.arcs) {
      if (arc_touches(body, arc, now_s_)) meet_cushion(place, cushion, false);
      ++cushion;
    }
  }

  /// Balls that still move outwards at a pocket's mouth when the contacts are resolved drop.
  void drop_balls() {
    const std::uint32_t pass = contacts_.next_pass() > 0 ? contacts_.next_pass() - 1 : 0;
    for (const AtPocket& at : at_pockets_) {
      Body<Real>& body = hand_[at.place];
      const bool out = dot(body.velocity, at.inward) < 0;
      if (!body.present || !out) continue;
      shot_.events.push_back(BasicBallPocket<Real>{now_s_, pass, body.id, at.pocket});
      body.moving() = {};
      body.present = false;
    }
  }

  void touch(std::uint32_t place) {
    if (!std::exchange(hand_[place].touched, true)) touched_.push_back(hand_[place].ball);
  }

  /// Gives every ball of the instant its new path and puts events and segments in order.
  void end_instant() {
    const std::size_t written = shot_.segments.size();
    if (!std::is_sorted(touched_.begin(), touched_.end())) {
      std::sort(touched_.begin(), touched_.end());
    }
    for (const std::uint32_t ball : touched_) {
      const Body<Real>& body = hand_.of(ball);
      if (!collisions_.empty()) collisions_[ball] = body.collisions;
      const Path<Real> path = path_of(body);
      calendar_.set(ball, path);
      write(path.segment, written);
    }
    calendar_.update();
    if (shot_.events.size() > first_event_ + 1) {
      std::sort(shot_.events.begin() + static_cast<std::ptrdiff_t>(first_event_),
                shot_.events.end(), comes_before<Real>);
    }
    if (written == first_segment_) return;
    std::sort(shot_.segments.begin() + static_cast<std::ptrdiff_t>(first_segment_),
              shot_.segments.end(), [](const auto& a, const auto& b) { return a.ball < b.ball; });
  }

  Path<Real> path_of(const Body<Real>& body) const {
    if (!body.present) {
      Path<Real> dropped;
      dropped.segment = {body.id, Phase::pocketed, now_s_, body.position, {}, {}, {}, {}};
      return dropped;
    }
    // They were taken up in ascending order.
    const auto found = std::lower_bound(ended_.begin(), ended_.end(), body.ball,
                                        [](const auto& e, std::uint32_t b) { return e.first < b; });
    if (found != ended_.end() && found->first == body.ball &&
        found->second.segment.velocity == body.velocity &&
        found->second.segment.spin == body.spin) {
      return found->second;
    }
    return laws_.cloth.path_from(body.id, now_s_, body.position, body.moving());
  }

  /// One segment a ball and instant: a second set at the same instant replaces those of the first.
  /// Those of earlier sets are in order of their balls, up to `written`.
  void write(const BasicSegment<Real>& segment, std::size_t written) {
    const auto end = shot_.segments.begin() + static_cast<std::ptrdiff_t>(written);
    const auto known =
        std::lower_bound(shot_.segments.begin() + static_cast<std::ptrdiff_t>(first_segment_), end,
                         segment, [](const auto& a, const auto& b) { return a.ball < b.ball; });
    if (known != end && known->ball == segment.ball) {
      *known = segment;
    } else {
      shot_.segments.push_back(segment);
    }
  }

  /// A ball that is at a pocket: it drops unless it turns back.
  struct AtPocket {
    std::uint32_t place;
    Vec inward;  ///< back to the table, any length
    PocketId pocket;
  };

  Laws<Real> laws_;
  Limits limits_;
  Calendar<Real> calendar_;
  ContactSet<Real> contacts_;
  std::vector<std::uint32_t> collisions_;  ///< of each ball so far, where normals are perturbed
  BasicShot<Real> shot_;
  std::size_t forgotten_events_ = 0;
  Progress progress_ = Progress::paused;
  Real now_s_{};
  // Of the present instant.
  Hand<Real> hand_;
  std::uint32_t sets_here_ = 0;
  std::size_t first_event_ = 0;
  std::size_t first_segment_ = 0;
  std::vector<std::uint32_t> touched_;
  std::vector<std::pair<std::uint32_t, Path<Real>>> ended_;
  std::vector<AtPocket> at_pockets_;
  StallCause cause_ = StallCause::events;
};

}  // namespace breakshot::physics
