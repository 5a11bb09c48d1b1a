// The paths of many balls as neighbours look at them, time and again: where a ball is, how it
// moves, and until when.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/physics/fetch_memory.hpp"
#include "common/physics/gathered.hpp"
#include "common/physics/pair_detector.hpp"

namespace breakshot::physics {

/// One cache line for a double.
template <class Real>
struct alignas(std::bit_ceil(8 * sizeof(Real))) Course {
  Real start_s{};
  BasicVec2<Real> position;
  BasicVec2<Real> velocity;
  BasicVec2<Real> acceleration;
  Real until_s = never<Real>;  ///< of the ball's next event, as far as is known
};

template <class Real>
BasicVec2<Real> position_at(const Course<Real>& m, Real time_s) {
  const Real dt = time_s - m.start_s;
  return {m.position.x + (m.velocity.x + m.acceleration.x * (dt / 2)) * dt,
          m.position.y + (m.velocity.y + m.acceleration.y * (dt / 2)) * dt};
}

template <class Real>
BasicVec2<Real> velocity_at(const Course<Real>& m, Real time_s) {
  const Real dt = time_s - m.start_s;
  return {m.velocity.x + m.acceleration.x * dt, m.velocity.y + m.acceleration.y * dt};
}

/// A path whose course is not copied.
template <class Real>
struct CoursePath {
  const Course<Real>& segment;
  Real speed;
  Real end_s;
  bool curved;
  bool still;
};

/// That of a ball which never slows down: its course says all.
template <class Real>
CoursePath<Real> even_path(const Course<Real>& course) {
  const Real speed = length(course.velocity);
  return {course, speed, never<Real>, false, speed == 0};
}

template <class Real>
bool stays(const CoursePath<Real>& path) {
  return path.still;
}

template <class Real>
class Courses {
 public:
  using Vec = BasicVec2<Real>;

  /// `straight`: no ball ever slows down.
  Courses(std::size_t balls, const PairDetector<Real>& detector, bool straight)
      : detector_(detector), straight_(straight), courses_(balls) {}

  const Course<Real>& operator[](std::size_t ball) const { return courses_[ball]; }

  /// Gives a ball another course; until when stays to be said.
  void set(std::size_t ball, const BasicSegment<Real>& s) {
    Course<Real>& course = courses_[ball];
    course.start_s = s.start_s;
    copy_in_parts(s.position, course.position);
    copy_in_parts(s.velocity, course.velocity);
    copy_in_parts(s.acceleration, course.acceleration);
  }
  void set_until(std::size_t ball, Real time_s) { courses_[ball].until_s = time_s; }

  /// Has memory fetched.
  void fetch(std::size_t ball) const { fetch_memory(&courses_[ball]); }

  /// Sets `near` to those of `found` whose centres are within `reach` of that of `ball` at `now_s`,
  /// itself among them; the others ascending.
  void find_within(std::uint32_t ball, Real reach, Real now_s, const Gathered& found,
                   Gathered& near) const {
    const Vec place = position_at(courses_[ball], now_s);
    std::uint32_t* const begin = near.begin_anew(found.size());
    std::uint32_t* end = begin;
    for (const std::uint32_t other : found) {
      const Vec d = position_at(courses_[other], now_s) - place;
      *end = other;
      end += dot(d, d) <= reach * reach;
    }
    near.end_at(end);
    if (end - begin > 2) std::sort(begin, end);
  }

  /// Sets `likely` to those of `found` that `ball`, as it is at `now_s`, may meet before `until_s`
  /// and their own next event: all that it does, and few others; itself among them.
  void find_likely(std::uint32_t ball, Real until_s, Real now_s, const Gathered& found,
                   Gathered& likely) const {
    const Course<Real>& own = courses_[ball];
    const Real last = smaller(until_s, now_s + Real(longest_span_s<Real>)) - now_s;
    const Vec p = position_at(own, now_s);
    const Vec v = velocity_at(own, now_s);
    std::uint32_t* end = likely.begin_anew(found.size());
    if (straight_) {
      for (const std::uint32_t other : found) {
        const Course<Real>& m = courses_[other];
        const Vec d = m.position + m.velocity * (now_s - m.start_s) - p;
        const Real span = smaller(m.until_s - now_s, last);
        *end = other;
        end += !(detector_.separation(d, m.velocity - v, span) > 0);
      }
    } else {
      for (const std::uint32_t other : found) {
        const Course<Real>& m = courses_[other];
        const Vec d = position_at(m, now_s) - p;
        const Real span = smaller(m.until_s - now_s, last);
        *end = other;
        end += !(detector_.separation(d, velocity_at(m, now_s) - v,
                                      m.acceleration - own.acceleration, span) > 0);
      }
    }
    likely.end_at(end);
  }

 private:
  PairDetector<Real> detector_;
  bool straight_;
  std::vector<Course<Real>> courses_;
};

}  // namespace breakshot::physics
