// What contacts do. All contacts of one instant are resolved as a set, in passes: the velocities
// are projected onto those in which no contact of the pass approaches, and restitution carries them
// on by as much again: v' = w + e (w - v) (with e = 1: Smith et al. 2012, "Reflections on
// Simultaneous Impact"; that the passes end: Vouga et al. 2017, "All's Well That Ends Well"). All
// balls of a scene are of one kind, so masses cancel.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/physics/event.hpp"
#include "common/physics/perturbation.hpp"
#include "common/physics/response.hpp"

namespace breakshot::physics {

/// Passes within one set, beyond which the shot is stalled.
inline constexpr std::uint32_t max_passes = 10'000;

/// Passes at one instant after which a set that takes energy and is still not at peace loses all
/// that approaches: balls wedged between others or in a corner, which would hand ever less back and
/// forth.
inline constexpr std::uint32_t patient_passes = 1'000;

template <class Real>
class ContactSet {
 public:
  using Vec = BasicVec2<Real>;

  ContactSet(const Laws<Real>& laws, const ShotSeed& seed)
      : laws_(laws), response_(laws), key_(key_of(seed, Stream::collisions)) {}

  /// Begins a set at a new instant, or goes on with one at the same instant from `first_pass`.
  void begin(std::uint32_t first_pass) {
    contacts_.clear();
    struck_.clear();
    pass_ = first_pass;
  }

  /// Whether the contact of two balls is known already.
  bool has(std::uint32_t a, std::uint32_t b) const {
    for (const Contact<Real>& known : contacts_) {
      if (known.cushion) continue;
      if ((known.a == a && known.b == b) || (known.a == b && known.b == a)) return true;
    }
    return false;
  }

  void add_balls(const std::vector<Body<Real>>& bodies, std::uint32_t a, std::uint32_t b,
                 bool predicted) {
    if (bodies[a].id > bodies[b].id) std::swap(a, b);
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

  /// Resolves the set and adds its events to `log`. `touching(ball)` is called once for every ball
  /// that takes part and adds the contacts that it has. False if the pass limit was reached.
  template <class Touching>
  bool settle(std::vector<Body<Real>>& bodies, Real time_s, std::vector<BasicEvent<Real>>& log,
              const Touching& touching) {
    if (contacts_.empty()) return true;
    std::size_t reached = 0;
    const std::uint32_t limit = pass_ + max_passes;
    // Every pass may bring in more balls, whose contacts come in with them.
    for (;; ++pass_) {
      if (pass_ == limit) return false;
      for (; reached < contacts_.size(); ++reached) {
        const std::uint32_t a = contacts_[reached].a;
        const std::uint32_t b = contacts_[reached].cushion ? a : contacts_[reached].b;
        if (join(a)) touching(a);
        if (join(b)) touching(b);
      }
      if (pass_ == limit - max_passes) unresolved_ = resolution(bodies);
      if (!pass(bodies, time_s, log) && !push_apart(bodies, time_s, log)) return true;
    }
  }

  /// All balls that took part.
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

  /// One pass over all contacts that approach. False if there is none.
  bool pass(std::vector<Body<Real>>& bodies, Real time_s, std::vector<BasicEvent<Real>>& log) {
    approaching_.clear();
    for (Contact<Real>& contact : contacts_) {
      const Real speed = approach(bodies, contact, contact.normal);
      if (speed > unresolved_ || (contact.predicted && speed > 0)) {
        approaching_.push_back(contact);
        contact.predicted = false;
      }
    }
    if (approaching_.empty()) return false;
    if (pass_ >= patient_passes && response_.wears(contacts_)) {
      stop_all(bodies);
    } else if (approaching_.size() == 1) {
      resolve_one(bodies, approaching_.front());
    } else {
      resolve_components(bodies);
    }
    for (const Contact<Real>& contact : approaching_) append_event(bodies, contact, time_s, log);
    return true;
  }

  void append_event(std::vector<Body<Real>>& bodies, const Contact<Real>& c, Real time_s,
                    std::vector<BasicEvent<Real>>& log) const {
    ++bodies[c.a].collisions;
    if (c.cushion) {
      log.push_back(BasicBallCushion<Real>{time_s, pass_, bodies[c.a].id, laws_.responses[c.b].id});
    } else {
      ++bodies[c.b].collisions;
      log.push_back(BasicBallBall<Real>{time_s, pass_, bodies[c.a].id, bodies[c.b].id});
    }
  }

  /// The end of patience: all contacts of the instant at once, so that none can hand on to another.
  void stop_all(std::vector<Body<Real>>& bodies) {
    sort_by_place(contacts_);
    normals_.clear();
    for (const Contact<Real>& contact : contacts_) normals_.push_back(contact.normal);
    response_.stop(bodies, contacts_, normals_);
  }

  static void sort_by_place(std::vector<Contact<Real>>& contacts) {
    std::sort(contacts.begin(), contacts.end(), [](const auto& p, const auto& q) {
      return p.point.x != q.point.x ? p.point.x < q.point.x : p.point.y < q.point.y;
    });
  }

  /// Splits the pass into connected sets, each solved on its own, contacts sorted by place.
  void resolve_components(std::vector<Body<Real>>& bodies) {
    rest_ = approaching_;
    sort_by_place(rest_);
    while (!rest_.empty()) {
      take_connected();
      resolve_connected(bodies, set_);
    }
  }

  /// Moves all that is connected with the first of rest_ to set_, in the same order.
  void take_connected() {
    taken_.assign(rest_.size(), false);
    taken_[0] = true;
    connected_.assign(1, 0);
    for (std::size_t i = 0; i < connected_.size(); ++i) {
      for (std::size_t k = 0; k < rest_.size(); ++k) {
        if (!taken_[k] && share_a_ball(rest_[connected_[i]], rest_[k])) {
          taken_[k] = true;
          connected_.push_back(k);
        }
      }
    }
    set_.clear();
    std::size_t left = 0;
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      if (taken_[k]) {
        set_.push_back(rest_[k]);
      } else {
        rest_[left++] = rest_[k];
      }
    }
    rest_.resize(left);
  }

  /// Resolves a contact with its perturbed normal. If it would still approach along its true
  /// normal, the rotation is taken back and the contact resolved again.
  void resolve_one(std::vector<Body<Real>>& bodies, const Contact<Real>& c) {
    Real tilt = tilt_of(bodies, c);
    Body<Real>& other = bodies[c.cushion ? c.a : c.b];
    const Moving<Real> before = bodies[c.a].moving();
    const Moving<Real> other_before = other.moving();
    for (;;) {
      response_.collide(bodies, c, turned(bodies, c, tilt));
      if (tilt == 0 || !(approach(bodies, c, c.normal) > 0)) return;
      tilt = 0;
      bodies[c.a].moving() = before;
      other.moving() = other_before;
    }
  }

  /// Resolves one connected set likewise: if one contact would still approach, all are resolved
  /// again without its rotation.
  void resolve_connected(std::vector<Body<Real>>& bodies, const std::vector<Contact<Real>>& set) {
    if (set.size() == 1) return resolve_one(bodies, set.front());
    tilts_.clear();
    for (const Contact<Real>& contact : set) tilts_.push_back(tilt_of(bodies, contact));
    keep(bodies, set);
    for (;;) {
      normals_.clear();
      for (std::size_t k = 0; k < set.size(); ++k) {
        normals_.push_back(turned(bodies, set[k], tilts_[k]));
      }
      response_.collide(bodies, set, normals_);
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

  /// The normal of a contact, turned by `tilt`; if the contact does not approach along that, the
  /// tilt becomes 0 and the normal stays true.
  static Vec turned(const std::vector<Body<Real>>& bodies, const Contact<Real>& c, Real& tilt) {
    if (tilt == 0) return c.normal;
    const Vec normal = c.normal + perp(c.normal) * tilt;
    if (approach(bodies, c, normal) > 0) return normal / length(normal);
    tilt = 0;
    return c.normal;
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

  /// Contacts that rest (`Laws::hop_of`): that touch, hardly part and would close again under their
  /// accelerations. They separate at their hop's speed: a push becomes a bounded number of hops.
  /// And a predicted contact of which rounding has left no approach is logged all the same. False
  /// if there is neither.
  bool push_apart(std::vector<Body<Real>>& bodies, Real time_s,
                  std::vector<BasicEvent<Real>>& log) {
    resting_.clear();
    bool any = false;
    for (Contact<Real>& contact : contacts_) {
      const bool resting = rests(bodies, contact);
      if (resting) resting_.push_back(contact);
      if (resting || contact.predicted) {
        append_event(bodies, contact, time_s, log);
        any = true;
      }
      contact.predicted = false;
    }
    if (!resting_.empty()) separate(bodies);
    return any;
  }

  bool rests(const std::vector<Body<Real>>& bodies, const Contact<Real>& contact) const {
    const Real apart = laws_.hop_of(response_.bounce_of(contact));
    const Real slow = larger(unresolved_, apart * laws_.resting_share);
    return apart > 0 && magnitude(approach(bodies, contact, contact.normal)) <= slow &&
           response_.closes(bodies, contact);
  }

  /// Lets resting_ hop, all from the same velocities: no order and no numbering shows. Where a ball
  /// has several, each gives its share, so that they bring no more energy than one by one.
  void separate(std::vector<Body<Real>>& bodies) {
    if (resting_.size() > 1) sort_by_place(resting_);
    changes_.clear();
    for (const Contact<Real>& c : resting_) {
      const Real change = laws_.hop_of(response_.bounce_of(c)) + approach(bodies, c, c.normal);
      const std::size_t shared =
          std::max(contacts_of(resting_, c.a), c.cushion ? 0 : contacts_of(resting_, c.b));
      changes_.push_back((c.cushion ? change : change / 2) / Real(shared));
    }
    for (std::size_t k = 0; k < resting_.size(); ++k) {
      response_.apply(bodies, resting_[k], resting_[k].normal, changes_[k]);
    }
  }

  const Laws<Real>& laws_;
  Response<Real> response_;
  PhiloxKey key_;
  Real unresolved_{};
  std::uint32_t pass_ = 0;
  std::vector<Contact<Real>> contacts_;
  std::vector<Contact<Real>> approaching_;
  std::vector<std::uint32_t> struck_;
  // Of the pass and of the connected set being resolved; kept between sets for their memory alone.
  std::vector<Contact<Real>> rest_;  ///< of the pass: in no connected set yet
  std::vector<Contact<Real>> resting_;
  std::vector<Contact<Real>> set_;
  std::vector<bool> taken_;
  std::vector<std::size_t> connected_;
  std::vector<Vec> normals_;
  std::vector<Moving<Real>> before_;
  std::vector<Real> tilts_;
  std::vector<Real> changes_;
};

}  // namespace breakshot::physics
