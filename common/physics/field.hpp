// All balls at one instant, in packs: what every ball is compared with at every event. The loops
// are free of branches, and what they find is a set of bits, so that the processor need not guess.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/physics/pack.hpp"
#include "common/physics/pair_detector.hpp"

namespace breakshot::physics {

template <class Real>
class Field {
 public:
  /// `straight`: paths never accelerate.
  Field(std::size_t balls, const PairDetector<Real>& detector, bool straight)
      : detector_(detector),
        straight_(straight),
        groups_((balls + Many::size - 1) / Many::size),
        sets_((balls + balls_of_a_set - 1) / balls_of_a_set) {
    std::size_t end = 0;
    for (Sets& sets : sets_) {
      sets.begin = end;
      sets.end = end = std::min(end + balls_of_a_set / Many::size, groups_.size());
    }
  }

  const PairDetector<Real>& detector() const { return detector_; }

  /// Gives a ball a new path, which starts at the instant of the field.
  void set(std::size_t ball, const Path<Real>& path) {
    const BasicSegment<Real>& s = path.segment;
    Group& group = groups_[ball / Many::size];
    const std::size_t i = ball % Many::size;
    group.start.set(i, s.start_s);
    physics::set(group.start_position, i, s.position);
    physics::set(group.position, i, s.position);
    physics::set(group.start_velocity, i, s.velocity);
    physics::set(group.velocity, i, s.velocity);
    physics::set(group.acceleration, i, s.acceleration);
    Sets& sets = sets_[ball / balls_of_a_set];
    set_bit(sets.present, ball % balls_of_a_set, s.phase != Phase::pocketed);
    set_bit(sets.moving, ball % balls_of_a_set, !is_still(s.phase));
  }

  /// The time of the earliest event that is known of a ball.
  void set_until(std::size_t ball, Real time_s) {
    groups_[ball / Many::size].until.set(ball % Many::size, time_s);
  }
  Real until(std::size_t ball) const { return groups_[ball / Many::size].until[ball % Many::size]; }

  Real earliest() const {
    Many least(never<Real>);
    for (const Group& group : groups_) least = smaller(least, group.until);
    Real first = least[0];
    for (std::size_t i = 1; i < Many::size; ++i) first = smaller(first, least[i]);
    return first;
  }

  /// Calls `due(ball)` for every ball, ascending, whose earliest event is at `time_s`, the earliest
  /// of all.
  template <class Due>
  void each_due(Real time_s, const Due& due) const {
    const Many now(time_s);
    each_of_all([](const Sets&) { return all; },
                [&now](const Group& group) { return not_above(group.until, now); }, due);
  }

  /// The balls at `time_s`, at which everything below is asked.
  void move_to(Real time_s) {
    now_s_ = time_s;
    const Many now(time_s);
    if (straight_) {
      for (Group& group : groups_) {
        group.position = group.start_position + group.velocity * (now - group.start);
      }
      return;
    }
    const Many half(Real(1) / 2);
    for (Group& group : groups_) {
      const Many dt = now - group.start;
      const BasicVec2<Many> change = group.acceleration * dt;
      group.position = group.start_position + (group.start_velocity + change * half) * dt;
      group.velocity = group.start_velocity + change;
    }
  }

  /// Calls `found(other)` for every other ball on the table, ascending, whose centre is within
  /// `reach` of that of `ball`.
  template <class Found>
  void each_within(std::size_t ball, Real reach, const Found& found) const {
    const BasicVec2<Many> place = pack_of(groups_[ball / Many::size].position, ball % Many::size);
    const Many square(reach * reach);
    each_of_all([this, ball](const Sets& sets) { return without(ball, sets, sets.present); },
                [&](const Group& group) {
                  const BasicVec2<Many> d = group.position - place;
                  return not_above(dot(d, d), square);
                },
                found);
  }

  /// Calls `found(other)` for every other ball on the table, ascending, that may meet `ball` before
  /// `until` of both: all that do, and few that do not. Of two balls one must move.
  template <class Found>
  void each_that_may_meet(std::size_t ball, const Found& found) const {
    const Group& own = groups_[ball / Many::size];
    const std::size_t k = ball % Many::size;
    const BasicVec2<Many> position = pack_of(own.position, k);
    const BasicVec2<Many> velocity = pack_of(own.velocity, k);
    const BasicVec2<Many> acceleration = pack_of(own.acceleration, k);
    const Many now(now_s_);
    const Many end(smaller(own.until[k], now_s_ + Real(longest_span_s<Real>)));
    const bool moves = (sets_[ball / balls_of_a_set].moving >> ball % balls_of_a_set & 1) != 0;
    const auto asked = [&](const Sets& sets) {
      return without(ball, sets, moves ? sets.present : sets.moving);
    };
    const auto test = [&](const Group& group, auto... bend) {
      const Many span = smaller(group.until, end) - now;
      return not_above(
          detector_.separation(group.position - position, group.velocity - velocity, bend..., span),
          Many{});
    };
    const auto test_bent = [&](const Group& group) {
      return test(group, group.acceleration - acceleration);
    };
    if (straight_) {
      each_of_all(asked, test, found);
    } else if (moves) {
      each_of_all(asked, test_bent, found);
    } else {
      each_of_few(asked, test_bent, found);
    }
  }

 private:
  using Many = Pack<Real>;

  struct Group {
    Many start;
    BasicVec2<Many> start_position, start_velocity, acceleration;
    BasicVec2<Many> position, velocity;
    Many until{never<Real>};
  };

  /// Some of 64 balls, one bit each.
  using Bits = std::uint64_t;
  static constexpr std::size_t balls_of_a_set = 64;
  static constexpr Bits all = ~Bits{0};
  struct Sets {
    Bits present = 0;  ///< on the table
    Bits moving = 0;
    std::size_t begin = 0;  ///< the groups
    std::size_t end = 0;
  };

  static void set_bit(Bits& set, std::size_t i, bool value) {
    set = (set & ~(Bits{1} << i)) | Bits{value} << i;
  }
  /// `bits`, of balls that `sets` is of, but for the ball itself.
  Bits without(std::size_t ball, const Sets& sets, Bits bits) const {
    const bool among = &sets == &sets_[ball / balls_of_a_set];
    return bits & ~(Bits{among} << ball % balls_of_a_set);
  }

  /// Calls `call(ball)` for every ball of the sets that `asked` gives for which `test`, of groups,
  /// gives a bit.
  template <class Asked, class Test, class Call>
  void each_of_all(const Asked& asked, const Test& test, const Call& call) const {
    std::size_t first = 0;
    for (const Sets& sets : sets_) {
      Bits found = 0;
      for (std::size_t g = sets.begin; g < sets.end; ++g) {
        found |= test(groups_[g]) << (g - sets.begin) * Many::size;
      }
      each_bit(found & asked(sets), first, call);
      first += balls_of_a_set;
    }
  }

  /// The same where groups without a ball that is asked for are many.
  template <class Asked, class Test, class Call>
  void each_of_few(const Asked& asked, const Test& test, const Call& call) const {
    constexpr Bits one_group = (Bits{1} << Many::size) - 1;
    std::size_t first = 0;
    for (const Sets& sets : sets_) {
      const Bits wanted = asked(sets);
      Bits found = 0;
      for (Bits left = wanted; left != 0;) {
        const std::size_t g = static_cast<std::size_t>(std::countr_zero(left)) / Many::size;
        found |= test(groups_[sets.begin + g]) << g * Many::size;
        left &= ~(one_group << g * Many::size);
      }
      each_bit(found & wanted, first, call);
      first += balls_of_a_set;
    }
  }

  template <class Call>
  static void each_bit(Bits bits, std::size_t first, const Call& call) {
    for (; bits != 0; bits &= bits - 1) {
      call(first + static_cast<std::size_t>(std::countr_zero(bits)));
    }
  }

  PairDetector<Real> detector_;
  bool straight_;
  std::vector<Group> groups_;
  std::vector<Sets> sets_;
  Real now_s_{};
};

}  // namespace breakshot::physics
