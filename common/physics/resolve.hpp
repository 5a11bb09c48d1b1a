// What contacts do. All contacts of one instant are resolved as a set, in passes: the velocities
// are projected onto those in which no contact of the pass approaches, and restitution carries them
// on by as much again: v' = w + e (w - v) (with e = 1: Smith et al. 2012, "Reflections on
// Simultaneous Impact"; that the passes end: Vouga et al. 2017, "All's Well That Ends Well"). All
// balls of a scene are of one kind, so masses cancel.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/physics/body.hpp"
#include "common/physics/detect.hpp"
#include "common/physics/event.hpp"
#include "common/physics/han2005.hpp"
#include "common/physics/mathavan2010.hpp"
#include "common/physics/mathavan2014.hpp"
#include "common/physics/perturbation.hpp"
#include "common/physics/projection.hpp"
#include "common/physics/stronge2000.hpp"

namespace breakshot::physics {

/// Passes within one set, beyond which the shot is stalled.
inline constexpr std::uint32_t max_passes = 10'000;

/// A contact with e < 1 that parts at no more than this share of its elastic_below, and closes
/// again under its accelerations, is one that rests. With three balls in a row friction eats the
/// hops of the one in the middle: without a least hop they would become ever smaller and never end.
inline constexpr double resting_share = 1e-3;

/// Two things that touch: balls `a` < `b`, or ball `a` and cushion `b`, counting arcs after noses.
template <class Real>
struct Contact {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  bool cushion = false;
  bool predicted = false;  ///< the event that brought us here: logged even if nothing is left of it
  BasicVec2<Real> normal;  ///< unit vector from a to the other
  BasicVec2<Real> point;   ///< twice the place of the contact: sorts a set independently of numbers
};

template <class Real>
class ContactSet {
 public:
  using Vec = BasicVec2<Real>;

  ContactSet(const Laws<Real>& laws, const ShotSeed& seed)
      : laws_(laws), key_(key_of(seed, Stream::collisions)) {}

  /// Begins a set at a new instant, or goes on with one at the same instant from `first_pass`.
  void begin(std::uint32_t first_pass) {
    contacts_.clear();
    events_.clear();
    struck_.clear();
    pass_ = first_pass;
  }

  /// Whether the contact of two balls is known already.
  bool has(std::uint32_t a, std::uint32_t b) const {
    for (const Contact<Real>& known : contacts_) {
      if (!known.cushion && known.a == smaller(a, b) && known.b == larger(a, b)) return true;
    }
    return false;
  }

  void add_balls(const std::vector<Body<Real>>& bodies, std::uint32_t a, std::uint32_t b,
                 bool predicted) {
    if (a > b) std::swap(a, b);
    const Vec between = bodies[b].position - bodies[a].position;
    add({a, b, false, predicted, between / length(between),
         bodies[a].position + bodies[b].position});
  }

  void add_cushion(const std::vector<Body<Real>>& bodies, std::uint32_t ball, std::uint32_t cushion,
                   bool predicted) {
    const Vec outward = outward_normal(cushion, bodies[ball].position);
    add({ball, cushion, true, predicted, outward,
         (bodies[ball].position + outward * laws_.radius) * Real(2)});
  }

  /// The unit vector from a ball to a cushion that it touches; arcs count after the noses.
  Vec outward_normal(std::uint32_t cushion, Vec position) const {
    if (cushion < laws_.noses.size()) return -laws_.noses[cushion].inward;
    const Arc<Real>& arc = laws_.arcs[cushion - laws_.noses.size()];
    const Vec between = arc.centre.segment.position - position;
    return between / length(between);
  }

  /// Resolves the set. `touching(ball)` is called once for every ball that takes part and adds the
  /// contacts that it has. False if the pass limit was reached.
  template <class Touching>
  bool settle(std::vector<Body<Real>>& bodies, Real time_s, Touching&& touching) {
    std::size_t reached = 0;
    const std::uint32_t limit = pass_ + max_passes;
    // Every pass may bring in more balls, whose contacts come in with them.
    for (;; ++pass_) {
      if (pass_ == limit) return false;
      for (; reached < contacts_.size(); ++reached) {
        const Contact<Real> contact = contacts_[reached];
        if (join(contact.a)) touching(contact.a);
        if (!contact.cushion && join(contact.b)) touching(contact.b);
      }
      if (pass_ == limit - max_passes) unresolved_ = resolution(bodies);
      if (!pass(bodies, time_s) && !push_apart(bodies, time_s)) return true;
    }
  }

  /// Events of the passes so far, and all balls that took part.
  const std::vector<BasicEvent<Real>>& events() const { return events_; }
  const std::vector<std::uint32_t>& balls() const { return struck_; }
  std::uint32_t next_pass() const { return pass_; }

 private:
  void add(const Contact<Real>& contact) {
    for (Contact<Real>& known : contacts_) {
      if (known.a == contact.a && known.b == contact.b && known.cushion == contact.cushion) {
        known.predicted = known.predicted || contact.predicted;
        return;
      }
    }
    contacts_.push_back(contact);
  }

  bool join(std::uint32_t ball) {
    if (std::find(struck_.begin(), struck_.end(), ball) != struck_.end()) return false;
    struck_.push_back(ball);
    return true;
  }

  Real resolution(const std::vector<Body<Real>>& bodies) const {
    Real top = 0;
    for (const std::uint32_t ball : struck_) {
      const Real speed = length(bodies[ball].velocity);
      top = speed > top ? speed : top;
    }
    return unresolved_speed(2 * top);
  }

  Vec relative_velocity(const std::vector<Body<Real>>& bodies, const Contact<Real>& c) const {
    return c.cushion ? bodies[c.a].velocity : bodies[c.a].velocity - bodies[c.b].velocity;
  }

  Real approach(const std::vector<Body<Real>>& bodies, const Contact<Real>& c, Vec normal) const {
    return dot(relative_velocity(bodies, c), normal);
  }

  /// One pass over all contacts that approach. False if there is none.
  bool pass(std::vector<Body<Real>>& bodies, Real time_s) {
    approaching_.clear();
    for (Contact<Real>& contact : contacts_) {
      const Real speed = approach(bodies, contact, contact.normal);
      if (speed > unresolved_ || (contact.predicted && speed > 0)) {
        approaching_.push_back(contact);
        contact.predicted = false;
      }
    }
    if (approaching_.empty()) return false;
    if (approaching_.size() == 1) {
      resolve_connected(bodies, approaching_);
    } else {
      resolve_components(bodies);
    }
    for (const Contact<Real>& contact : approaching_) append_event(bodies, contact, time_s);
    return true;
  }

  void append_event(std::vector<Body<Real>>& bodies, const Contact<Real>& c, Real time_s) {
    ++bodies[c.a].collisions;
    if (c.cushion) {
      events_.push_back(
          BasicBallCushion<Real>{time_s, pass_, bodies[c.a].id, laws_.responses[c.b].id});
    } else {
      ++bodies[c.b].collisions;
      events_.push_back(BasicBallBall<Real>{time_s, pass_, bodies[c.a].id, bodies[c.b].id});
    }
  }

  /// Splits the pass into connected sets, each solved on its own, contacts sorted by place.
  void resolve_components(std::vector<Body<Real>>& bodies) {
    std::vector<Contact<Real>> rest = approaching_;
    std::sort(rest.begin(), rest.end(), [](const Contact<Real>& p, const Contact<Real>& q) {
      return p.point.x != q.point.x ? p.point.x < q.point.x : p.point.y < q.point.y;
    });
    while (!rest.empty()) {
      std::vector<Contact<Real>> connected = {rest.front()};
      std::vector<bool> taken(rest.size());
      taken[0] = true;
      for (std::size_t i = 0; i < connected.size(); ++i) {
        for (std::size_t k = 0; k < rest.size(); ++k) {
          if (!taken[k] && share_a_ball(connected[i], rest[k])) {
            taken[k] = true;
            connected.push_back(rest[k]);
          }
        }
      }
      std::vector<Contact<Real>> set;
      std::vector<Contact<Real>> others;
      for (std::size_t k = 0; k < rest.size(); ++k) (taken[k] ? set : others).push_back(rest[k]);
      resolve_connected(bodies, set);
      rest = std::move(others);
    }
  }

  static bool share_a_ball(const Contact<Real>& p, const Contact<Real>& q) {
    return p.a == q.a || (!q.cushion && p.a == q.b) || (!p.cushion && p.b == q.a) ||
           (!p.cushion && !q.cushion && p.b == q.b);
  }

  /// Resolves one connected set with its perturbed normals. A contact that would still approach
  /// along its true normal has its rotation taken back, and the pass is done again.
  void resolve_connected(std::vector<Body<Real>>& bodies, const std::vector<Contact<Real>>& set) {
    tilts_.clear();
    for (const Contact<Real>& contact : set) tilts_.push_back(tilt_of(bodies, contact));
    keep(bodies, set);
    for (;;) {
      tilt(bodies, set);
      collide(bodies, set);
      bool again = false;
      for (std::size_t k = 0; k < set.size(); ++k) {
        if (tilts_[k] != 0 && approach(bodies, set[k], set[k].normal) > 0) {
          tilts_[k] = 0;
          again = true;
        }
      }
      if (!again) return;
      restore(bodies, set);
    }
  }

  Real tilt_of(const std::vector<Body<Real>>& bodies, const Contact<Real>& c) const {
    const double scale = c.cushion ? laws_.perturb_cushions : laws_.perturb_balls;
    if (scale == 0) return 0;
    const std::uint32_t other =
        c.cushion ? 0x80000000u + number(laws_.responses[c.b].id) : number(bodies[c.b].id);
    const std::uint32_t other_count = c.cushion ? 0 : bodies[c.b].collisions;
    return Real(scale *
                symmetric(philox(
                    {number(bodies[c.a].id), other, bodies[c.a].collisions, other_count}, key_)));
  }

  /// Sets the normals of the pass; a normal along which the contact does not approach stays true.
  void tilt(const std::vector<Body<Real>>& bodies, const std::vector<Contact<Real>>& set) {
    normals_.clear();
    for (std::size_t k = 0; k < set.size(); ++k) {
      normals_.push_back(set[k].normal);
      if (tilts_[k] == 0) continue;
      const Vec turned = set[k].normal + perp(set[k].normal) * tilts_[k];
      if (approach(bodies, set[k], turned) > 0) {
        normals_.back() = turned / length(turned);
      } else {
        tilts_[k] = 0;
      }
    }
  }

  void keep(const std::vector<Body<Real>>& bodies, const std::vector<Contact<Real>>& set) {
    before_.clear();
    for (const Contact<Real>& c : set) {
      before_.push_back(bodies[c.a].moving());
      before_.push_back(bodies[c.cushion ? c.a : c.b].moving());
    }
  }

  void restore(std::vector<Body<Real>>& bodies, const std::vector<Contact<Real>>& set) const {
    for (std::size_t k = 0; k < set.size(); ++k) {
      bodies[set[k].a].moving() = before_[2 * k];
      if (!set[k].cushion) bodies[set[k].b].moving() = before_[2 * k + 1];
    }
  }

  const Bounce<Real>& bounce_of(const Contact<Real>& c) const {
    return c.cushion ? laws_.responses[c.b].bounce : laws_.ball_ball->bounce;
  }

  Touch touch_of(const Contact<Real>& c) const {
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

  /// Normal impulses along normals_, then what happens across them.
  void collide(std::vector<Body<Real>>& bodies, const std::vector<Contact<Real>>& set) {
    Real largest = 0;
    rates_.clear();
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Real speed = approach(bodies, set[k], normals_[k]);
      largest = speed > largest ? speed : largest;
      rates_.push_back(-speed);
    }
    const Real restitution = restitution_of(set, largest);
    if (set.size() == 1) {
      collide_one(bodies, set[0], largest, restitution);
      return;
    }
    const std::vector<Real> gram = gram_of(set);
    NonNegativeImpulses<Real> impulses(gram, rates_);
    sizes_ = impulses.solve();
    for (std::size_t k = 0; k < set.size(); ++k) {
      sizes_[k] *= 1 + restitution;
      apply(bodies, set[k], normals_[k], sizes_[k]);
    }
    for (std::size_t k = 0; k < set.size(); ++k) hold(bodies, set[k], normals_[k]);
    rub(bodies, set);
  }

  /// The direct path of nearly all contacts.
  void collide_one(std::vector<Body<Real>>& bodies, const Contact<Real>& c, Real speed,
                   Real restitution) {
    const Vec normal = normals_[0];
    const Real factor = 1 + restitution;
    if (c.cushion) {
      const NoseResponse<Real>& nose = laws_.responses[c.b];
      Moving<Real>& ball = bodies[c.a].moving();
      switch (nose.touch) {
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
    } else if (laws_.ball_ball->touch == Touch::integrated) {
      collide_mathavan2014(bodies[c.a].moving(), bodies[c.b].moving(), normal, restitution,
                           laws_.ball_ball->law);
    } else {
      apply(bodies, c, normal, factor / 2 * speed);
      if (laws_.ball_ball->touch == Touch::smooth) return;
      const PairLaw<Real>& law = laws_.ball_ball->law;
      push_pair(bodies, c, normal,
                pair_friction(bodies[c.a].moving(), bodies[c.b].moving(), normal,
                              factor / 2 * speed, Real(1), law));
    }
  }

  /// Friction of all contacts of a set at once, from the same velocities. Where a ball has several
  /// contacts, each may take its share of what would stop the slip: so energy cannot rise.
  void rub(std::vector<Body<Real>>& bodies, const std::vector<Contact<Real>>& set) {
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
            nose_friction(a, nose_direction(normals_[k], law), sizes_[k], share, law));
      } else {
        frictions_.push_back(pair_friction(a, bodies[c.b].moving(), normals_[k], sizes_[k], share,
                                           laws_.ball_ball->law));
      }
    }
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Contact<Real>& c = set[k];
      if (touch_of(c) == Touch::smooth) continue;
      if (c.cushion) {
        const NoseLaw<Real>& law = laws_.responses[c.b].law;
        push(bodies[c.a].moving(), nose_direction(normals_[k], law) * law.radius, frictions_[k],
             law.radius);
      } else {
        push_pair(bodies, c, normals_[k], frictions_[k]);
      }
    }
  }

  void push_pair(std::vector<Body<Real>>& bodies, const Contact<Real>& c, Vec normal,
                 BasicVec3<Real> impulse) const {
    const BasicVec3<Real> to_contact{normal.x * laws_.radius, normal.y * laws_.radius, Real(0)};
    push(bodies[c.a].moving(), to_contact, impulse, laws_.radius);
    push(bodies[c.b].moving(), to_contact * Real(-1), impulse * Real(-1), laws_.radius);
  }

  static std::size_t most_contacts_of_a_ball(const std::vector<Contact<Real>>& set) {
    std::size_t most = 1;
    for (const Contact<Real>& c : set) {
      std::size_t of_a = 0;
      std::size_t of_b = 0;
      for (const Contact<Real>& other : set) {
        of_a += has_ball(other, c.a);
        of_b += !c.cushion && has_ball(other, c.b);
      }
      most = std::max({most, of_a, of_b});
    }
    return most;
  }

  static bool has_ball(const Contact<Real>& c, std::uint32_t ball) {
    return c.a == ball || (!c.cushion && c.b == ball);
  }

  std::vector<Real> gram_of(const std::vector<Contact<Real>>& set) const {
    const std::size_t n = set.size();
    std::vector<Real> gram(n * n);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t l = 0; l < n; ++l) {
        const Real product = dot(normals_[k], normals_[l]);
        Real& sum = gram[k * n + l];
        if (set[k].a == set[l].a) sum += product;
        if (!set[k].cushion && set[k].b == set[l].a) sum -= product;
        if (!set[l].cushion && set[k].a == set[l].b) sum -= product;
        if (!set[k].cushion && !set[l].cushion && set[k].b == set[l].b) sum += product;
        if (k == l) sum = set[k].cushion ? Real(1) : Real(2);
      }
    }
    return gram;
  }

  void apply(std::vector<Body<Real>>& bodies, const Contact<Real>& c, Vec normal,
             Real speed) const {
    bodies[c.a].velocity = bodies[c.a].velocity - normal * speed;
    if (!c.cushion) bodies[c.b].velocity = bodies[c.b].velocity + normal * speed;
  }

  void hold(std::vector<Body<Real>>& bodies, const Contact<Real>& c, Vec normal) const {
    if (!c.cushion || laws_.responses[c.b].tangential == 1) return;
    const Vec tangent = perp(normal);
    Vec& velocity = bodies[c.a].velocity;
    const Real lost = (1 - laws_.responses[c.b].tangential) * dot(velocity, tangent);
    velocity = velocity - tangent * lost;
  }

  /// Contacts with e < 1 that touch, hardly part and would close again under their accelerations
  /// separate at the speed below which such contacts are elastic: a push becomes a bounded number
  /// of hops. And a predicted contact of which rounding has left no approach is logged all the
  /// same. False if there is neither.
  bool push_apart(std::vector<Body<Real>>& bodies, Real time_s) {
    bool any = false;
    for (Contact<Real>& contact : contacts_) {
      const Real speed = approach(bodies, contact, contact.normal);
      const Real apart = bounce_of(contact).elastic_below_m_s;
      const Real slow = larger(unresolved_, apart * Real(resting_share));
      const bool rests = magnitude(speed) <= slow && apart > 0 && closes(bodies, contact);
      if (rests) {
        const Real change = apart + speed;
        apply(bodies, contact, contact.normal, contact.cushion ? change : change / 2);
      }
      if (rests || contact.predicted) {
        append_event(bodies, contact, time_s);
        any = true;
      }
      contact.predicted = false;
    }
    return any;
  }

  /// Whether the second derivative of the gap is negative. Without spin a ball that leaves a cushion
  /// only slows down: it does not come back, however its deceleration points.
  bool closes(const std::vector<Body<Real>>& bodies, const Contact<Real>& c) const {
    const Vec pull = laws_.cloth.acceleration_of(bodies[c.a].moving());
    if (c.cushion) return laws_.cloth.spins() && dot(pull, c.normal) > 0;
    const Vec velocity = relative_velocity(bodies, c);
    const Vec acceleration = pull - laws_.cloth.acceleration_of(bodies[c.b].moving());
    const Vec between = bodies[c.b].position - bodies[c.a].position;
    return dot(velocity, velocity) - dot(acceleration, between) < 0;
  }

  const Laws<Real>& laws_;
  PhiloxKey key_;
  Real unresolved_{};
  std::uint32_t pass_ = 0;
  std::vector<Contact<Real>> contacts_;
  std::vector<Contact<Real>> approaching_;
  std::vector<std::uint32_t> struck_;
  std::vector<BasicEvent<Real>> events_;
  // Of the connected set being resolved; kept between sets for their memory alone.
  std::vector<Vec> normals_;
  std::vector<Moving<Real>> before_;
  std::vector<Real> tilts_;
  std::vector<Real> rates_;
  std::vector<Real> sizes_;
  std::vector<BasicVec3<Real>> frictions_;
};

}  // namespace breakshot::physics
