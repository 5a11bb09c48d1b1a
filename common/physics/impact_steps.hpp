// Integration of one impact over its normal impulse, with Stronge's restitution of energy: the
// impact ends when the work that the normal force has given back is e^2 times the work that it has
// taken (Stronge 1990, "Rigid body collisions with friction").
//
// A step is symmetric: half of the normal impulse with the friction at the contact, friction on the
// bed, the other half. In a half step all changes are linear, so that work is known exactly, on
// both sides of the turn of the approach too. What remains of the impact, in impulse without
// friction, is known at any time; each step takes an equal share of it at the rate at which the
// last step made it fall, and a purely normal impulse, small of second order, then meets the end
// exactly. So the result is a continuous function of the state before (but where friction changes
// the rate by half within a step), and the energy balance is exact: e^2 - 1 times the work taken,
// less what friction takes.
#pragma once

#include <cmath>
#include <cstdint>

namespace breakshot::physics {

/// Steps of an impact whose normal force sets the pace. Twice as many change velocities and spins,
/// by the speeds before, by 1e-4 in the mean with a nose and 1e-5 with a ball, by 1e-2 and 2e-3 at
/// most for frictions up to 0.4 and 0.2 (a contact that begins to hold while the bed drags at it is
/// first order); with the published parameters by 2e-3 and 1e-6 at most.
inline constexpr int impact_steps = 32;

/// Steps of any impact, for each step asked for. Where friction of a coefficient near or above 1
/// wedges a ball, or draws it in, the impact is longer; what then remains is given without
/// friction.
inline constexpr int longest_impact = 16;

/// Friction may draw a ball in: 2^50 times the approach at the start is more than 100 m/s are for
/// 1e-12 m/s, and its square is within the range of every scalar. There the impact ends at once.
inline constexpr std::int64_t greatest_growth = std::int64_t{1} << 50;

/// Work in units of start^2 / mobility, approaches in units of the approach at the start.
template <class Real>
struct Work {
  Real taken{};
  Real returned{};

  /// The approach goes linearly from `from` to `to` over an impulse that alone would change it by
  /// `effort`.
  void add(Real from, Real to, Real effort) {
    if (from >= 0 && to >= 0) {
      taken += (from + to) / 2 * effort;
    } else if (from <= 0 && to <= 0) {
      returned -= (from + to) / 2 * effort;
    } else {
      const Real share = effort / (2 * (from < to ? to - from : from - to));
      taken += (from > 0 ? from * from : to * to) * share;
      returned += (from > 0 ? to * to : from * from) * share;
    }
  }

  /// The approach at which normal force alone would end an impact that is now at `approach`.
  Real end_from(Real approach, Real restitution) const {
    using std::sqrt;
    const Real due = restitution * restitution * taken - returned;
    const Real square = approach * approach;
    const Real end = approach > 0 ? restitution * restitution * square + 2 * due : square + 2 * due;
    return end > 0 ? -sqrt(end) : Real(0);
  }
};

/// What the halves of the steps brought to the bed. Friction there acts between the halves of a
/// step, before the second is known: that is taken to differ from the first as it did in the step
/// before. What is wrong where friction begins to hold is thereby made good one step later.
template <class Real>
class TwoHalves {
 public:
  void add(Real half) {
    before_ = last_;
    last_ = half;
  }
  /// Of a step whose first half was added last.
  Real both() {
    const Real sum = 2 * last_ + (before_ - first_);
    first_ = last_;
    return sum;
  }

 private:
  Real first_{};  ///< of the step before
  Real before_{};
  Real last_{};
};

/// `Contact` has `approach()`, the velocity that the normal impulse works against; `mobility()`,
/// how much of it a unit of normal impulse takes; `push(P)`, a normal impulse alone; `press(P)`,
/// one with friction at the contact; and `rub()`, friction on the bed for twice what the last press
/// has brought there. The approach must be positive.
template <class Contact, class Real>
class Impact {
 public:
  Impact(const Contact& contact, Real restitution)
      : contact_(contact),
        restitution_(restitution),
        start_(contact.approach()),
        mobility_(contact.mobility()) {}

  Contact after(int steps) {
    int left = steps;
    Real rate = 1;
    for (int step = 0; step < longest_impact * steps && left > 0; ++step) {
      const Real before = remaining();
      if (!(before > 0) || before > Real(greatest_growth)) break;
      const Impact start = *this;
      advance(before / (rate * Real(left)));
      const Real gone = before - remaining();
      if (gone > before && left > 1) {
        *this = start;
        rate *= 2;
        continue;
      }
      const Real next = gone / before * rate * Real(left);
      if (2 * Real(left) * gone >= before) --left;
      rate = next > Real(1) / 4 ? next : Real(1) / 4;
    }
    contact_.push(remaining() * start_ / mobility_);
    return contact_;
  }

 private:
  Real approach() const { return contact_.approach() / start_; }
  Real remaining() const { return approach() - work_.end_from(approach(), restitution_); }

  void advance(Real effort) {
    press(effort / 2);
    contact_.rub();
    press(effort / 2);
  }

  void press(Real effort) {
    const Real from = approach();
    contact_.press(effort * start_ / mobility_);
    work_.add(from, approach(), effort);
  }

  Contact contact_;
  Real restitution_;
  Real start_;
  Real mobility_;
  Work<Real> work_;
};

}  // namespace breakshot::physics
