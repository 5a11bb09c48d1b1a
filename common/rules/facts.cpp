#include "common/rules/facts.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "common/physics/rails.hpp"
#include "common/physics/table.hpp"
#include "common/rules/groups.hpp"

namespace breakshot::rules {
namespace {

using physics::BallId;
using physics::CushionArc;
using physics::CushionSegment;
using physics::Segment;
using physics::Shot;
using physics::Vec2;

/// The greatest of dot(axis, position) on one segment up to `end_s`: at an end, or where the
/// velocity along the axis changes its sign.
double greatest_on(const Segment& segment, Vec2 axis, double end_s) {
  double greatest = std::max(dot(axis, position_at(segment, segment.start_s)),
                             dot(axis, position_at(segment, end_s)));
  const double speed = dot(axis, segment.velocity);
  const double acceleration = dot(axis, segment.acceleration);
  if (speed > 0 && acceleration < 0) {
    const double turn_s = segment.start_s + speed / -acceleration;
    if (turn_s < end_s) greatest = std::max(greatest, dot(axis, position_at(segment, turn_s)));
  }
  return greatest;
}

/// The greatest of dot(axis, position) on the path of `ball` from the start of the shot until
/// `until_s`.
double greatest_along(const Shot& shot, BallId ball, Vec2 axis, double until_s) {
  double greatest = -std::numeric_limits<double>::infinity();
  const Segment* last = nullptr;
  for (const Segment& segment : shot.segments) {
    if (segment.ball != ball) continue;
    if (last != nullptr && segment.start_s > until_s) break;
    if (last != nullptr) {
      greatest = std::max(greatest, greatest_on(*last, axis, segment.start_s));
    }
    last = &segment;
  }
  return last == nullptr ? greatest : std::max(greatest, greatest_on(*last, axis, until_s));
}

/// Where a ball stands before a piece of a cushion: the nearest point of the nose, and the unit
/// vector from there to the ball.
struct Standing {
  Vec2 nose;
  Vec2 normal;
};

/// Nothing where the ball is not in front of the piece.
std::optional<Standing> standing_at(const CushionSegment& segment, Vec2 position) {
  const Vec2 along = segment.to - segment.from;
  const double extent = length(along);
  const double foot = dot(along, position - segment.from) / extent;
  if (foot < 0 || foot > extent) return std::nullopt;
  return Standing{segment.from, perp(along) / extent};
}

std::optional<Standing> standing_at(const CushionArc& arc, Vec2 position) {
  const Vec2 outward = position - arc.centre;
  if (cross(arc.from, outward) < 0 || cross(outward, arc.to) < 0) return std::nullopt;
  const Vec2 normal = outward / length(outward);
  return Standing{arc.centre + normal * arc.radius_m, normal};
}

/// Whether a ball meets a cushion that it was not touching (WPA 8.4): it did not touch it before
/// the shot, or has left it since. The jaws of a pocket are cushions like the others.
class Rails {
 public:
  Rails(const physics::Scene& scene, const physics::State& before, const Shot& shot)
      : radius_m_(scene.ball.radius_m),
        rails_(physics::rails_of(scene)),
        before_(before),
        shot_(shot) {}

  bool driven(const physics::BallCushion& contact) const {
    return driven(contact, rails_.segments) && driven(contact, rails_.arcs);
  }

 private:
  template <class Piece>
  bool driven(const physics::BallCushion& contact, const std::vector<Piece>& pieces) const {
    const physics::Ball* ball = find(before_, contact.ball);
    if (ball == nullptr) return true;
    return std::none_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
      if (piece.id != contact.cushion) return false;
      const auto standing = standing_at(piece.nose, ball->position);
      if (!standing || gap(*standing, dot(standing->normal, ball->position)) > frozen_gap_m) {
        return false;
      }
      const double farthest = greatest_along(shot_, contact.ball, standing->normal, contact.time_s);
      return gap(*standing, farthest) <= frozen_gap_m;
    });
  }

  /// Between nose and ball, for a ball whose centre is so far along the normal.
  double gap(const Standing& standing, double along) const {
    return along - dot(standing.normal, standing.nose) - radius_m_;
  }

  double radius_m_;
  physics::Rails rails_;
  const physics::State& before_;
  const Shot& shot_;
};

/// The moment of the cue ball's first contact: what comes later in the same instant comes after.
using Moment = std::pair<double, std::uint32_t>;

/// The contacts of the cue ball at the instant of its first one.
std::optional<Moment> note_first_hits(Facts& facts, const Shot& shot) {
  std::optional<Moment> first;
  for (const physics::Event& event : shot.events) {
    const auto* contact = std::get_if<physics::BallBall>(&event);
    if (contact == nullptr) continue;
    if (contact->lower != cue_ball && contact->higher != cue_ball) continue;
    if (first && contact->time_s > first->first) break;
    const BallId hit = contact->lower == cue_ball ? contact->higher : contact->lower;
    if (!first) {
      first = Moment{contact->time_s, contact->pass};
      facts.first_hit = hit;
    }
    facts.first_hits.push_back(hit);
  }
  std::sort(facts.first_hits.begin(), facts.first_hits.end());
  facts.first_hits.erase(std::unique(facts.first_hits.begin(), facts.first_hits.end()),
                         facts.first_hits.end());
  return first;
}

void note_rails_and_pockets(Facts& facts, const Rails& rails, const Shot& shot,
                            const std::optional<Moment>& first) {
  for (const physics::Event& event : shot.events) {
    if (const auto* drop = std::get_if<physics::BallPocket>(&event)) {
      facts.pocketed.push_back({drop->ball, drop->pocket, drop->time_s});
    }
    const auto* contact = std::get_if<physics::BallCushion>(&event);
    if (contact == nullptr || !rails.driven(*contact)) continue;
    if (contact->ball != cue_ball) facts.object_balls_to_cushion.push_back(contact->ball);
    if (first && Moment{contact->time_s, contact->pass} > *first) {
      facts.cushion_after_contact = true;
    }
  }
  auto& balls = facts.object_balls_to_cushion;
  std::sort(balls.begin(), balls.end());
  balls.erase(std::unique(balls.begin(), balls.end()), balls.end());
}

}  // namespace

Facts facts_of(const physics::Scene& scene, const physics::State& before, const Shot& shot) {
  Facts facts;
  const std::optional<Moment> first = note_first_hits(facts, shot);
  note_rails_and_pockets(facts, Rails(scene, before, shot), shot, first);

  const double string_x = head_string_x(scene.bed);
  const double until_s = first ? first->first : shot.end_s;
  facts.crossed_head_string_before_contact =
      greatest_along(shot, cue_ball, {1, 0}, until_s) > string_x;
  facts.first_hit_beyond_head_string =
      std::any_of(facts.first_hits.begin(), facts.first_hits.end(), [&](BallId id) {
        const physics::Ball* ball = find(before, id);
        return ball != nullptr && ball->position.x >= string_x;
      });
  return facts;
}

}  // namespace breakshot::rules
