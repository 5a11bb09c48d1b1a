// Straight noses in packs: the first that a path comes to. Which one that is cannot be guessed, and
// a wrong guess costs a processor more than working out the times of all.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
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
  Meeting first(const Path<Real>& path, Real until_s) const {
    if (path.curved) return one_by_one(path, until_s);
    return path.segment.acceleration == BasicVec2<Real>{} ? in_packs<true>(path, until_s)
                                                          : in_packs<false>(path, until_s);
  }

 private:
  using Many = Pack<Real>;

  struct Group {
    BasicVec2<Many> from, along, inward;
    Many extent;
  };

  Meeting one_by_one(const Path<Real>& path, Real until_s) const {
    Meeting first{until_s, 0};
    for (std::uint32_t i = 0; i < count_; ++i) {
      const Real t = cushion_time(path, noses_[i], radius_, top_speed_, first.time_s);
      if (t < first.time_s) first = {t, i};
    }
    return first;
  }

  /// Of paths that do not turn back; `even`: nor slow down. The same operations as in
  /// cushion_time(), or such as give the same bits.
  template <bool even>
  Meeting in_packs(const Path<Real>& path, Real until_s) const {
    const BasicSegment<Real>& s = path.segment;
    const BasicVec2<Many> position = pack_of(s.position);
    const BasicVec2<Many> velocity = pack_of(s.velocity);
    const BasicVec2<Many> acceleration = pack_of(s.acceleration);
    const Many zero{};
    const Many radius(radius_);
    const Many start(s.start_s);
    const Many end(path.end_s);
    const Many touch(
        touch_gap_bound(larger(radius_, largest_coordinate(s.position)), path.speed, s.start_s));
    const Many slow(slow_below<Real>);
    Many least(until_s);
    Many group_of_least{};
    Many number{};
    std::uint64_t delicate = 0;
    for (const Group& group : groups_) {
      const Many gap = dot(position - group.from, group.inward) - radius;
      const Many towards = zero - dot(velocity, group.inward);
      const std::uint64_t comes = ~not_above(towards, zero);
      delicate |= comes & (not_above(gap, touch) | not_above(towards, slow));
      Many t;
      Many time;
      BasicVec2<Many> way;
      if constexpr (even) {
        t = gap / towards;
        way = velocity * t;
        time = start + t;
      } else {
        const Many pull = zero - dot(acceleration, group.inward);
        const Many square = towards * towards + (pull + pull) * gap;
        t = (gap + gap) / (towards + root(square));
        way = (velocity + acceleration * (t * Many(Real(1) / 2))) * t;
        time = where_above(start + t, square, zero);
      }
      const Many foot = dot(position + way - group.from, group.along);
      time = where_above(time, towards, zero);
      time = where_not_above(time, time, end);
      time = where_not_above(time, zero, foot);
      time = where_not_above(time, foot, group.extent);
      group_of_least = chosen(time, least, number, group_of_least);
      least = smaller(least, time);
      number = number + Many(Real(1));
    }
    if ((delicate & one_group) != 0) return one_by_one(path, until_s);
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

  static constexpr std::uint64_t one_group = (std::uint64_t{1} << Many::size) - 1;

  const std::vector<Nose<Real>>& noses_;
  std::vector<Group> groups_;
  std::size_t count_;
  Real radius_;
  Real top_speed_;
};

}  // namespace breakshot::physics
