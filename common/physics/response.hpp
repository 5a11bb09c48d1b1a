// What contacts do to the balls that have them: restitution along the normals of a connected set,
// and each model's way across them. All balls of a scene are of one kind, so masses cancel.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/physics/contact.hpp"
#include "common/physics/detect.hpp"
#include "common/physics/han2005.hpp"
#include "common/physics/mathavan2010.hpp"
#include "common/physics/mathavan2014.hpp"
#include "common/physics/projection.hpp"
#include "common/physics/stronge2000.hpp"

namespace breakshot::physics {

template <class Real>
class Response {
 public:
  using Vec = BasicVec2<Real>;

  explicit Response(const Laws<Real>& laws) : laws_(laws) {}

  const Bounce<Real>& bounce_of(const Contact<Real>& c) const {
    return c.cushion ? laws_.responses[c.b].bounce : laws_.ball_ball->bounce;
  }

  Touch touch_of(const Contact<Real>& c) const {
    if (plain_engine) return Touch::smooth;
    return c.cushion ? laws_.responses[c.b].touch : laws_.ball_ball->touch;
  }

  /// The set's restitution: the smallest holds, at the set's largest approach.
  Real restitution_of(const std::vector<Contact<Real>>& set, Real largest) const {
    Bounce<Real> least = bounce_of(set.front());
    for (const Contact<Real>& contact : set) {
      const Bounce<Real>& bounce = bounce_of(contact);
      if (bounce.restitution < least.restitution ||
          (bounce.restitution == least.restitution &&
           bounce.elastic_below_m_s > least.elastic_below_m_s)) {
        least = bounce;
      }
    }
    return least.at(largest);
  }

  /// Normal impulses of a set of several along their normals, then what happens across them.
  void collide(std::vector<Body<Real>>& bodies, const std::vector<Contact<Real>>& set,
               const std::vector<Vec>& normals) {
    const Real largest = read_rates(bodies, set, normals);
    apply_impulses(bodies, set, normals, 1 + restitution_of(set, largest));
    for (std::size_t k = 0; k < set.size(); ++k) hold(bodies, set[k], normals[k]);
    rub(bodies, set, normals);
    for (const Contact<Real>& contact : set) forget_spin(bodies, contact);
  }

  /// The direct path of nearly all contacts.
  void collide(std::vector<Body<Real>>& bodies, const Contact<Real>& c, Vec normal) const {
    const Real speed = larger(Real(0), approach(bodies, c, normal));
    collide_one(bodies, c, normal, speed, bounce_of(c).at(speed));
    forget_spin(bodies, c);
  }

  /// Takes from a set all that approaches, and gives nothing back.
  void stop(std::vector<Body<Real>>& bodies, const std::vector<Contact<Real>>& set,
            const std::vector<Vec>& normals) {
    read_rates(bodies, set, normals);
    apply_impulses(bodies, set, normals, Real(1));
  }

  /// Whether a contact of the set takes energy.
  bool wears(const std::vector<Contact<Real>>& set) const {
    return std::any_of(set.begin(), set.end(), [this](const Contact<Real>& c) {
      return bounce_of(c).restitution < 1 || touch_of(c) != Touch::smooth ||
             (c.cushion && laws_.responses[c.b].tangential < 1);
    });
  }

  /// Whether the second derivative of the gap is negative. Without spin a ball that leaves a
  /// cushion only slows down: it does not come back, however its deceleration points.
  bool closes(const std::vector<Body<Real>>& bodies, const Contact<Real>& c) const {
    const Vec pull = laws_.cloth.acceleration_of(bodies[c.a].moving());
    if (c.cushion) return laws_.cloth.spins() && dot(pull, c.normal) > 0;
    const Vec velocity = relative_velocity(bodies, c);
    const Vec acceleration = pull - laws_.cloth.acceleration_of(bodies[c.b].moving());
    const Vec between = bodies[c.b].position - bodies[c.a].position;
    return dot(velocity, velocity) - dot(acceleration, between) < 0;
  }

  /// Changes the velocities of a contact by a speed along its normal, away from one another.
  void apply(std::vector<Body<Real>>& bodies, const Contact<Real>& c, Vec normal,
             Real speed) const {
    bodies[c.a].velocity = bodies[c.a].velocity - normal * speed;
    if (!c.cushion) bodies[c.b].velocity = bodies[c.b].velocity + normal * speed;
  }

 private:
  /// How fast the contacts close, negative; and the greatest speed of approach.
  Real read_rates(const std::vector<Body<Real>>& bodies, const std::vector<Contact<Real>>& set,
                  const std::vector<Vec>& normals) {
    Real largest = 0;
    rates_.clear();
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Real speed = approach(bodies, set[k], normals[k]);
      largest = speed > largest ? speed : largest;
      rates_.push_back(-speed);
    }
    return largest;
  }

  /// A motion without spin keeps none between contacts either.
  void forget_spin(std::vector<Body<Real>>& bodies, const Contact<Real>& c) const {
    if (laws_.cloth.spins()) return;
    bodies[c.a].spin = {};
    if (!c.cushion) bodies[c.b].spin = {};
  }

  /// Normal impulses: `factor` times those after which no contact of the set approaches.
  void apply_impulses(std::vector<Body<Real>>& bodies, const std::vector<Contact<Real>>& set,
                      const std::vector<Vec>& normals, Real factor) {
    set_gram(set, normals);
    sizes_ = impulses_.solve(gram_, rates_);
    for (std::size_t k = 0; k < set.size(); ++k) {
      sizes_[k] *= factor;
      apply(bodies, set[k], normals[k], sizes_[k]);
    }
  }

  void collide_one(std::vector<Body<Real>>& bodies, const Contact<Real>& c, Vec normal, Real speed,
                   Real restitution) const {
    const Real factor = 1 + restitution;
    if (c.cushion) {
      const NoseResponse<Real>& nose = laws_.responses[c.b];
      Moving<Real>& ball = bodies[c.a].moving();
      switch (touch_of(c)) {
        case Touch::smooth:
          apply(bodies, c, normal, factor * speed);
          hold(bodies, c, normal);
          return;
        case Touch::rubs:
          ball = after_han2005(ball, normal, restitution, nose.law);
          return;
        case Touch::integrated:
          ball = after_mathavan2010(ball, normal, restitution, nose.law);
          return;
        case Touch::compliant:
          ball = after_stronge2000(ball, normal, restitution, nose.law);
          return;
      }
    } else if (touch_of(c) == Touch::integrated) {
      collide_mathavan2014(bodies[c.a].moving(), bodies[c.b].moving(), normal, restitution,
                           laws_.ball_ball->law);
    } else {
      apply(bodies, c, normal, factor / 2 * speed);
      if (touch_of(c) == Touch::smooth) return;
      const PairLaw<Real>& law = laws_.ball_ball->law;
      push_pair(bodies, c, normal,
                pair_friction(bodies[c.a].moving(), bodies[c.b].moving(), normal,
                              factor / 2 * speed, Real(1), law));
    }
  }

  /// Friction of all contacts of a set at once, from the same velocities. Where a ball has several
  /// contacts, each may take its share of what would stop the slip: so energy cannot rise.
  void rub(std::vector<Body<Real>>& bodies, const std::vector<Contact<Real>>& set,
           const std::vector<Vec>& normals) {
    const Real share = Real(1) / Real(most_contacts_of_a_ball(set));
    frictions_.clear();
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Contact<Real>& c = set[k];
      const Moving<Real>& a = bodies[c.a].moving();
      if (touch_of(c) == Touch::smooth) {
        frictions_.push_back({});
      } else if (c.cushion) {
        const NoseLaw<Real>& law = laws_.responses[c.b].law;
        frictions_.push_back(
            nose_friction(a, nose_direction(normals[k], law), sizes_[k], share, law));
      } else {
        frictions_.push_back(pair_friction(a, bodies[c.b].moving(), normals[k], sizes_[k], share,
                                           laws_.ball_ball->law));
      }
    }
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Contact<Real>& c = set[k];
      if (touch_of(c) == Touch::smooth) continue;
      if (c.cushion) {
        const NoseLaw<Real>& law = laws_.responses[c.b].law;
        push(bodies[c.a].moving(), nose_direction(normals[k], law) * law.radius, frictions_[k],
             law.radius);
      } else {
        push_pair(bodies, c, normals[k], frictions_[k]);
      }
    }
  }

  void push_pair(std::vector<Body<Real>>& bodies, const Contact<Real>& c, Vec normal,
                 BasicVec3<Real> impulse) const {
    const BasicVec3<Real> to_contact{normal.x * laws_.radius, normal.y * laws_.radius, Real(0)};
    push(bodies[c.a].moving(), to_contact, impulse, laws_.radius);
    push(bodies[c.b].moving(), to_contact * Real(-1), impulse * Real(-1), laws_.radius);
  }

  void set_gram(const std::vector<Contact<Real>>& set, const std::vector<Vec>& normals) {
    const std::size_t n = set.size();
    gram_.assign(n * n, Real(0));
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t l = 0; l < n; ++l) {
        const Real product = dot(normals[k], normals[l]);
        Real& sum = gram_[k * n + l];
        if (set[k].a == set[l].a) sum += product;
        if (!set[k].cushion && set[k].b == set[l].a) sum -= product;
        if (!set[l].cushion && set[k].a == set[l].b) sum -= product;
        if (!set[k].cushion && !set[l].cushion && set[k].b == set[l].b) sum += product;
        if (k == l) sum = set[k].cushion ? Real(1) : Real(2);
      }
    }
  }

  void hold(std::vector<Body<Real>>& bodies, const Contact<Real>& c, Vec normal) const {
    if (!c.cushion || laws_.responses[c.b].tangential == 1) return;
    const Vec tangent = perp(normal);
    Vec& velocity = bodies[c.a].velocity;
    const Real lost = (1 - laws_.responses[c.b].tangential) * dot(velocity, tangent);
    velocity = velocity - tangent * lost;
  }

  const Laws<Real>& laws_;
  // Of the set being resolved; kept between sets for their memory alone.
  NonNegativeImpulses<Real> impulses_;
  std::vector<Real> gram_;
  std::vector<Real> rates_;
  std::vector<Real> sizes_;
  std::vector<BasicVec3<Real>> frictions_;
};

}  // namespace breakshot::physics
