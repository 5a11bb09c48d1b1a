// Straight noses in packs: the first that a path comes to. Which one that is cannot be guessed, and
// a wrong guess costs a processor more than working out the times of all.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/physics/detect.hpp"
#include "common/physics/pack.hpp"

namespace breakshot::physics {

template <class Real>
class Noses {
 public:
  struct Meeting {
    Real time_s = never<Real>;
    std::uint32_t nose = 0;
  };

  /// The first `count` of `noses`, which must stay where they are; for balls of `radius`, m, none
  /// of them faster than `top_speed`, m/s.
  Noses(const std::vector<Nose<Real>>& noses, std::size_t count, Real radius, Real top_speed)
      : noses_(noses),
        groups_((count + Many::size - 1) / Many::size),
        count_(count),
        radius_(radius),
        top_speed_(top_speed) {
    for (std::size_t i = 0; i < count; ++i) {
      Group& group = groups_[i / Many::size];
      set(group.from, i % Many::size, noses[i].from);
      set(group.along, i % Many::size, noses[i].along);
      set(group.inward, i % Many::size, noses[i].inward);
      group.extent.set(i % Many::size, noses[i].extent);
    }
  }

  bool empty() const { return count_ == 0; }

  /// The first that the path meets, the lowest of several, as cushion_time() has it; or none if
  /// that is not before `until_s`, which is then its time.
  template <PathLike Mover>
  Meeting first(const Mover& path, Real until_s) const {
    if (path.curved) return first_one_by_one(path, until_s);
    return path.segment.acceleration == BasicVec2<Real>{} ? first_of_straight<true>(path, until_s)
                                                          : first_of_straight<false>(path, until_s);
  }

 private:
  using Many = Pack<Real>;

  struct Group {
    BasicVec2<Many> from, along, inward;
    Many extent;
  };

  /// The start of a path, beside a whole group of noses.
  struct Start {
    template <class Segment>
    explicit Start(const Segment& s)
        : position(pack_of(s.position)),
          velocity(pack_of(s.velocity)),
          acceleration(pack_of(s.acceleration)) {}
    BasicVec2<Many> position, velocity, acceleration;
  };

  /// A bit for each nose of a group, and more.
  using Bits = std::uint64_t;
  static constexpr Bits one_group = (Bits{1} << Many::size) - 1;

  template <PathLike Mover>
  Meeting first_one_by_one(const Mover& path, Real until_s) const {
    const auto& s = path.segment;
    const Start at(s);
    const Many zero{};
    // How far a ball is, but for rounding, that touches.
    const Many touch(radius_ + touch_gap_bound(larger(radius_, largest_coordinate(s.position)),
                                               path.speed, s.start_s));
    const Many span(until_s - s.start_s);
    const Many half(Real(1) / 2);
    Meeting first{until_s, 0};
    std::uint32_t begin = 0;
    for (const Group& group : groups_) {
      const Many towards = larger(zero - dot(at.velocity, group.inward), zero);
      const Many pull = larger(zero - dot(at.acceleration, group.inward), zero);
      const Many reach = (towards + pull * span * half) * span * Many(Real(never_farther));
      const Many distance = dot(at.position - group.from, group.inward);
      for (Bits near = not_above(distance, reach + touch) & one_group; near != 0;
           near &= near - 1) {
        const std::uint32_t i = begin + static_cast<std::uint32_t>(std::countr_zero(near));
        if (i >= count_) break;
        const Real t = cushion_time(path, noses_[i], radius_, top_speed_, first.time_s);
        if (t < first.time_s) first = {t, i};
      }
      begin += Many::size;
    }
    return first;
  }

  /// Of straight paths that do not turn back, nor slow down if they are `even`: all at once, by the
  /// operations of cushion_time() or such as give the same bits.
  template <bool even, PathLike Mover>
  Meeting first_of_straight(const Mover& path, Real until_s) const {
    const auto& s = path.segment;
    const Start at(s);
    const Many zero{};
    const Many radius(radius_);
    const Many start(s.start_s);
    const Many end(path.end_s);
    const Many span(Real(never_farther) * (until_s - s.start_s));
    const Many touch(
        touch_gap_bound(larger(radius_, largest_coordinate(s.position)), path.speed, s.start_s));
    const Many slow(slow_below<Real>);
    Many least(until_s);
    Many group_of_least{};
    Many number{};
    Bits delicate = 0;
    for (const Group& group : groups_) {
      const Many own_number = number;
      number = number + Many(Real(1));
      const Many gap = dot(at.position - group.from, group.inward) - radius;
      const Many towards = zero - dot(at.velocity, group.inward);
      const Bits comes = ~not_above(towards, zero) & one_group;
      delicate |= comes & (not_above(gap, touch) | not_above(towards, slow));
      // What slows down mostly stops before it comes to a nose.
      if (!even && (comes & not_above(gap, towards * span)) == 0) continue;
      const auto [time, way] = [&]() -> std::pair<Many, BasicVec2<Many>> {
        if constexpr (even) {
          const Many t = gap / towards;
          return {start + t, at.velocity * t};
        } else {
          const Many pull = zero - dot(at.acceleration, group.inward);
          const Many square = towards * towards + (pull + pull) * gap;
          const Many t = (gap + gap) / (towards + root(square));
          return {where_above(start + t, square, zero),
                  (at.velocity + at.acceleration * (t * Many(Real(1) / 2))) * t};
        }
      }();
      const Many foot = dot(at.position + way - group.from, group.along);
      Many met = where_above(time, towards, zero);
      met = where_not_above(met, met, end);
      met = where_not_above(met, zero, foot);
      met = where_not_above(met, foot, group.extent);
      group_of_least = chosen(met, least, own_number, group_of_least);
      least = smaller(least, met);
    }
    if (delicate != 0) return first_one_by_one(path, until_s);
    return least_of(least, group_of_least, until_s);
  }

  static Meeting least_of(Many least, Many group_of_least, Real until_s) {
    Real time_s = least[0];
    for (std::size_t i = 1; i < Many::size; ++i) time_s = smaller(time_s, least[i]);
    if (!(time_s < until_s)) return {until_s, 0};
    std::uint64_t places = not_above(least, Many(time_s));
    const auto nose = [&] {
      const auto i = static_cast<std::uint32_t>(std::countr_zero(places));
      return static_cast<std::uint32_t>(group_of_least[i]) * std::uint32_t{Many::size} + i;
    };
    Meeting first{time_s, nose()};
    while ((places &= places - 1) != 0) first.nose = std::min(first.nose, nose());
    return first;
  }

  const std::vector<Nose<Real>>& noses_;
  std::vector<Group> groups_;
  std::size_t count_;
  Real radius_;
  Real top_speed_;
};

}  // namespace breakshot::physics
