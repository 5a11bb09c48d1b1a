// All balls at one instant, as rows of numbers: what every ball is compared with at every event.
// The loops over a row are free of branches, so that a compiler makes vector instructions of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/physics/pair_detector.hpp"

namespace breakshot::physics {

template <class Real>
class Field {
  static constexpr std::size_t lanes = 4;
  struct Row {
    using Numbers = std::array<Real, lanes>;
    Numbers start, start_x, start_y, start_vx, start_vy, ax, ay;
    Numbers x, y, vx, vy;
    Numbers until;
  };

 public:
  Field(std::size_t balls, Real diameter)
      : detector_(diameter), rows_((balls + lanes - 1) / lanes), balls_(balls) {
    for (Row& row : rows_) row.until.fill(never<Real>);
  }

  const PairDetector<Real>& detector() const { return detector_; }

  /// Gives a ball a new path, which starts at the instant of the field.
  void set(std::size_t ball, const Path<Real>& path) {
    const BasicSegment<Real>& s = path.segment;
    Row& row = rows_[ball / lanes];
    const std::size_t i = ball % lanes;
    row.start[i] = s.start_s;
    row.start_x[i] = row.x[i] = s.position.x;
    row.start_y[i] = row.y[i] = s.position.y;
    row.start_vx[i] = row.vx[i] = s.velocity.x;
    row.start_vy[i] = row.vy[i] = s.velocity.y;
    row.ax[i] = s.acceleration.x;
    row.ay[i] = s.acceleration.y;
  }

  /// The time of the earliest event that is known of a ball.
  void set_until(std::size_t ball, Real time_s) {
    rows_[ball / lanes].until[ball % lanes] = time_s;
  }
  Real until(std::size_t ball) const { return rows_[ball / lanes].until[ball % lanes]; }

  Real earliest() const {
    typename Row::Numbers least;
    least.fill(never<Real>);
    for (const Row& row : rows_) {
      for (std::size_t i = 0; i < lanes; ++i) {
        least[i] = smaller(least[i], row.until[i]);
      }
    }
    return *std::min_element(least.begin(), least.end());
  }

  /// Calls `due(ball)` for every ball whose earliest event is at `time_s`.
  template <class Due>
  void each_due(Real time_s, const Due& due) const {
    std::size_t first = 0;
    for (const Row& row : rows_) {
      for (std::size_t i = 0; i < lanes; ++i) {
        if (row.until[i] == time_s) due(first + i);
      }
      first += lanes;
    }
  }

  /// The balls at `time_s`, at which everything below is asked.
  void move_to(Real time_s) {
    now_s_ = time_s;
    for (Row& row : rows_) {
      for (std::size_t i = 0; i < lanes; ++i) {
        const Real dt = time_s - row.start[i];
        const Real half = dt / 2;
        row.x[i] = row.start_x[i] + (row.start_vx[i] + row.ax[i] * half) * dt;
        row.y[i] = row.start_y[i] + (row.start_vy[i] + row.ay[i] * half) * dt;
        row.vx[i] = row.start_vx[i] + row.ax[i] * dt;
        row.vy[i] = row.start_vy[i] + row.ay[i] * dt;
      }
    }
  }

  /// Calls `found(other)` for every other ball whose centre is within `reach` of that of `ball`.
  template <class Found>
  void each_within(std::size_t ball, Real reach, const Found& found) const {
    const Row& own = rows_[ball / lanes];
    const BasicVec2<Real> p{own.x[ball % lanes], own.y[ball % lanes]};
    std::size_t first = 0;
    for (const Row& row : rows_) {
      typename Row::Numbers measure;
      for (std::size_t i = 0; i < lanes; ++i) {
        const BasicVec2<Real> d{row.x[i] - p.x, row.y[i] - p.y};
        measure[i] = dot(d, d) - reach * reach;
      }
      report(ball, first, measure, found);
      first += lanes;
    }
  }

  /// Calls `found(other)` for every other ball that may meet `ball` before `until` of both: all
  /// that do, and few that do not.
  template <class Found>
  void each_that_may_meet(std::size_t ball, const Found& found) const {
    const Row& own = rows_[ball / lanes];
    const std::size_t k = ball % lanes;
    const BasicVec2<Real> p{own.x[k], own.y[k]};
    const BasicVec2<Real> v{own.vx[k], own.vy[k]};
    const BasicVec2<Real> a{own.ax[k], own.ay[k]};
    const Real last = now_s_ + Real(longest_span_s<Real>);
    const Real end = smaller(own.until[k], last);
    std::size_t first = 0;
    for (const Row& row : rows_) {
      typename Row::Numbers measure;
      for (std::size_t i = 0; i < lanes; ++i) {
        const Real until = smaller(row.until[i], end);
        const BasicVec2<Real> d{row.x[i] - p.x, row.y[i] - p.y};
        const BasicVec2<Real> w{row.vx[i] - v.x, row.vy[i] - v.y};
        const BasicVec2<Real> bend{row.ax[i] - a.x, row.ay[i] - a.y};
        measure[i] = detector_.separation(d, w, bend, until - now_s_);
      }
      report(ball, first, measure, found);
      first += lanes;
    }
  }

 private:
  template <class Found>
  void report(std::size_t ball, std::size_t first, const std::array<Real, lanes>& measure,
              const Found& found) const {
    const Real least = smaller(smaller(measure[0], measure[1]), smaller(measure[2], measure[3]));
    if (least > 0) return;
    for (std::size_t i = 0; i < lanes; ++i) {
      if (!(measure[i] > 0) && first + i != ball && first + i < balls_) found(first + i);
    }
  }

  PairDetector<Real> detector_;
  std::vector<Row> rows_;
  std::size_t balls_;
  Real now_s_{};
};

}  // namespace breakshot::physics
