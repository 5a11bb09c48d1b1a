// The impulses of simultaneous contacts: the projection of velocities onto those in which no
// contact approaches, as a non-negative least-squares problem (Lawson and Hanson 1974, "Solving
// Least Squares Problems", chapter 23) on the contacts' Gram matrix.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace breakshot::physics {

/// Finds the smallest l >= 0 with rates + gram l >= 0 and l (rates + gram l) = 0, each to rounding.
/// Kept between sets for its memory alone.
template <class Real>
class NonNegativeImpulses {
 public:
  /// `gram` is symmetric and row-major, `rates` has one entry a contact, negative for an approach.
  /// The answer holds until the next question.
  const std::vector<Real>& solve(const std::vector<Real>& gram, const std::vector<Real>& rates) {
    gram_ = gram;
    rates_ = rates;
    size_ = rates.size();
    impulses_.assign(size_, Real(0));
    dependent_.assign(size_, false);
    active_.clear();
    // Each step adds a contact for good or removes one and lowers the residual; this bound is
    // Lawson and Hanson's practical one.
    for (std::size_t step = 0; step < 3 * size_ + 8; ++step) {
      const std::size_t worst = most_approaching();
      if (worst == size_) break;
      active_.push_back(worst);
      settle();
    }
    return impulses_;
  }

 private:
  Real entry(std::size_t row, std::size_t column) const { return gram_[row * size_ + column]; }

  Real residual(std::size_t row) const {
    Real sum = rates_[row];
    for (std::size_t k = 0; k < size_; ++k) sum += entry(row, k) * impulses_[k];
    return sum;
  }

  bool is_active(std::size_t k) const {
    for (const std::size_t active : active_) {
      if (active == k) return true;
    }
    return false;
  }

  /// The contact outside the active set that approaches most, or size_ when none does.
  std::size_t most_approaching() const {
    Real scale = 0;
    for (const Real& rate : rates_) scale = rate < -scale ? -rate : scale;
    Real least = -64 * std::numeric_limits<Real>::epsilon() * scale;
    std::size_t worst = size_;
    for (std::size_t k = 0; k < size_; ++k) {
      if (dependent_[k] || is_active(k)) continue;
      const Real rate = residual(k);
      if (rate < least) {
        least = rate;
        worst = k;
      }
    }
    return worst;
  }

  /// Solves for the active contacts; drops those that would have to pull.
  void settle() {
    while (!active_.empty()) {
      if (!factor()) continue;
      set_to_minus_rates(wanted_);
      solve_factored(wanted_);
      refine();
      Real step = 1;
      for (std::size_t i = 0; i < active_.size(); ++i) {
        const Real now = impulses_[active_[i]];
        if (wanted_[i] <= 0 && now < step * (now - wanted_[i])) step = now / (now - wanted_[i]);
      }
      for (std::size_t i = 0; i < active_.size(); ++i) {
        Real& impulse = impulses_[active_[i]];
        impulse = step == 1 ? wanted_[i] : impulse + step * (wanted_[i] - impulse);
      }
      if (step == 1 && none_pulls()) return;
      drop_pulling();
    }
  }

  bool none_pulls() const {
    for (const Real& impulse : wanted_) {
      if (impulse <= 0) return false;
    }
    return true;
  }

  void drop_pulling() {
    const Real negligible = 16 * std::numeric_limits<Real>::epsilon();
    Real largest = 0;
    for (const std::size_t k : active_) largest = impulses_[k] > largest ? impulses_[k] : largest;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const std::size_t k = active_[i];
      if (wanted_[i] <= 0 && impulses_[k] <= negligible * largest) {
        impulses_[k] = 0;
      } else {
        active_[kept++] = k;
      }
    }
    active_.resize(kept);
  }

  void set_to_minus_rates(std::vector<Real>& right) const {
    right.clear();
    for (const std::size_t k : active_) right.push_back(-rates_[k]);
  }

  /// Cholesky's factor of the active part of the Gram matrix. A contact that depends on the others
  /// is left out: when the others do not approach, neither does it.
  bool factor() {
    using std::sqrt;
    const Real singular = 4096 * std::numeric_limits<Real>::epsilon();
    const std::size_t n = active_.size();
    factor_.assign(n * n, Real(0));
    for (std::size_t row = 0; row < n; ++row) {
      for (std::size_t column = 0; column <= row; ++column) {
        Real sum = entry(active_[row], active_[column]);
        for (std::size_t k = 0; k < column; ++k) {
          sum -= factor_[row * n + k] * factor_[column * n + k];
        }
        if (row != column) {
          factor_[row * n + column] = sum / factor_[column * n + column];
        } else if (sum > singular * entry(active_[row], active_[row])) {
          factor_[row * n + row] = sqrt(sum);
        } else {
          dependent_[active_[row]] = true;
          impulses_[active_[row]] = 0;
          active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(row));
          return false;
        }
      }
    }
    return true;
  }

  void solve_factored(std::vector<Real>& x) const {
    const std::size_t n = active_.size();
    for (std::size_t row = 0; row < n; ++row) {
      for (std::size_t k = 0; k < row; ++k) x[row] -= factor_[row * n + k] * x[k];
      x[row] /= factor_[row * n + row];
    }
    for (std::size_t row = n; row-- > 0;) {
      for (std::size_t k = row + 1; k < n; ++k) x[row] -= factor_[k * n + row] * x[k];
      x[row] /= factor_[row * n + row];
    }
  }

  /// One step of iterative refinement takes the error of the factor out.
  void refine() {
    set_to_minus_rates(error_);
    for (std::size_t i = 0; i < active_.size(); ++i) {
      for (std::size_t k = 0; k < active_.size(); ++k) {
        error_[i] -= entry(active_[i], active_[k]) * wanted_[k];
      }
    }
    solve_factored(error_);
    for (std::size_t i = 0; i < active_.size(); ++i) wanted_[i] += error_[i];
  }

  std::vector<Real> gram_;
  std::vector<Real> rates_;
  std::size_t size_ = 0;
  std::vector<Real> impulses_;
  std::vector<bool> dependent_;
  std::vector<std::size_t> active_;
  std::vector<Real> factor_;
  std::vector<Real> wanted_;
  std::vector<Real> error_;
};

}  // namespace breakshot::physics
