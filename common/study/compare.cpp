#include "common/study/compare.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace breakshot::study {
namespace {

using physics::BallId;
using Segment = physics::BasicSegment<Reference>;
using Vec = physics::BasicVec2<Reference>;

enum class Kind { ball, cushion, pocket };

/// What a ball meets.
struct Thing {
  Kind kind = Kind::ball;
  std::uint32_t number = 0;

  friend bool operator==(const Thing&, const Thing&) = default;
};

struct Meeting {
  Reference time_s;
  Thing with;
};

/// One ball through a shot.
struct Career {
  std::vector<Segment> path;
  std::vector<Meeting> meetings;

  const Segment& at(const Reference& time_s) const {
    const auto after =
        std::upper_bound(path.begin(), path.end(), time_s,
                         [](const Reference& t, const Segment& s) { return t < s.start_s; });
    return after == path.begin() ? path.front() : *(after - 1);
  }
  /// The segment that ends at an event of this time.
  const Segment& before(const Reference& time_s) const {
    const auto at =
        std::lower_bound(path.begin(), path.end(), time_s,
                         [](const Segment& s, const Reference& t) { return s.start_s < t; });
    return at == path.begin() ? path.front() : *(at - 1);
  }
  Vec position(const Reference& time_s) const { return position_at(at(time_s), time_s); }

  void meet(const Reference& time_s, Thing thing) {
    const bool hop =
        !meetings.empty() && meetings.back().with == thing && time_s - last_s < Reference(hop_s);
    last_s = time_s;
    if (!hop) meetings.push_back({time_s, thing});
  }

  Reference last_s;
};

double as_double(const Reference& x) {
  return static_cast<double>(x);
}

double distance(const Vec& a, const Vec& b) {
  return as_double(length(a - b));
}

/// What happened to every ball, and what players see of it.
class Account {
 public:
  Account(const WideShot& shot, double diameter_m, const std::optional<BallId>& struck)
      : end_s_(shot.end_s) {
    for (const Segment& segment : shot.segments) careers_[segment.ball].path.push_back(segment);
    for (const auto& event : shot.events) {
      if (const auto* balls = std::get_if<physics::BasicBallBall<Reference>>(&event)) {
        meet(*balls, Reference(diameter_m), struck);
      } else if (const auto* rail = std::get_if<physics::BasicBallCushion<Reference>>(&event)) {
        careers_[rail->ball].meet(rail->time_s, {Kind::cushion, number(rail->cushion)});
        at_cushions_.insert(rail->ball);
      } else if (const auto* drop = std::get_if<physics::BasicBallPocket<Reference>>(&event)) {
        careers_[drop->ball].meet(drop->time_s, {Kind::pocket, number(drop->pocket)});
        pocketed_.insert(drop->ball);
      }
    }
  }

  const std::map<BallId, Career>& careers() const { return careers_; }
  const Reference& end_s() const { return end_s_; }
  const std::optional<BallId>& first_contact() const { return first_contact_; }
  const std::set<BallId>& at_cushions() const { return at_cushions_; }
  const std::set<BallId>& pocketed() const { return pocketed_; }
  double overlap_m() const { return overlap_m_; }

  /// By mass, m^2/s^2.
  double energy(const Reference& time_s, double radius_m) const {
    double sum = 0;
    for (const auto& [ball, career] : careers_) {
      const Segment& s = career.at(time_s);
      const Vec v = velocity_at(s, time_s);
      const physics::BasicVec3<Reference> spin = spin_at(s, time_s);
      sum += as_double(dot(v, v)) / 2 + 0.2 * radius_m * radius_m * as_double(dot(spin, spin));
    }
    return sum;
  }

 private:
  void meet(const physics::BasicBallBall<Reference>& e, const Reference& diameter_m,
            const std::optional<BallId>& struck) {
    Career& a = careers_[e.lower];
    Career& b = careers_[e.higher];
    const Vec between =
        position_at(a.before(e.time_s), e.time_s) - position_at(b.before(e.time_s), e.time_s);
    overlap_m_ = std::max(overlap_m_, as_double(diameter_m - length(between)));
    a.meet(e.time_s, {Kind::ball, number(e.higher)});
    b.meet(e.time_s, {Kind::ball, number(e.lower)});
    if (!first_contact_ && struck == e.lower) first_contact_ = e.higher;
    if (!first_contact_ && struck == e.higher) first_contact_ = e.lower;
  }

  Reference end_s_;
  std::map<BallId, Career> careers_;
  std::optional<BallId> first_contact_;
  std::set<BallId> at_cushions_;
  std::set<BallId> pocketed_;
  double overlap_m_ = 0;
};

void compare_contacts(const Career& career, const Career& truth, Comparison& result) {
  bool right = true;
  for (std::size_t k = 0; k < std::min(truth.meetings.size(), most_contacts); ++k) {
    ContactErrors& errors = result.contacts[k];
    ++errors.balls;
    right =
        right && k < career.meetings.size() && career.meetings[k].with == truth.meetings[k].with;
    if (!right) {
      ++errors.wrong;
      continue;
    }
    const Reference& time_s = career.meetings[k].time_s;
    const Reference& true_time_s = truth.meetings[k].time_s;
    errors.times_s.push_back(as_double(abs(time_s - true_time_s)));
    errors.positions_m.push_back(distance(career.position(time_s), truth.position(true_time_s)));
  }
}

void compare_ends(const Account& account, const Account& truth, Comparison& result) {
  for (const auto& [ball, career] : truth.careers()) {
    ++result.end.balls;
    if (account.pocketed().contains(ball) != truth.pocketed().contains(ball)) {
      ++result.end.wrong;
      continue;
    }
    const Reference time_s = std::min(truth.end_s(), account.end_s());
    result.end.positions_m.push_back(
        distance(account.careers().at(ball).position(time_s), career.position(truth.end_s())));
  }
}

}  // namespace

Comparison compare(const WideShot& shot, const WideShot& reference, const physics::Scene& scene,
                   const std::optional<BallId>& struck) {
  const double radius_m = scene.ball.radius_m;
  const Account account(shot, 2 * radius_m, struck);
  const Account truth(reference, 2 * radius_m, struck);
  Comparison result;
  for (const auto& [ball, career] : truth.careers()) {
    compare_contacts(account.careers().at(ball), career, result);
  }
  compare_ends(account, truth, result);
  result.overlap_m = account.overlap_m();
  const Reference quarter_s = truth.end_s() / 4;
  const double start = truth.energy(Reference(0), radius_m);
  const double drift = account.energy(quarter_s, radius_m) - truth.energy(quarter_s, radius_m);
  if (start > 0) result.energy = std::abs(drift) / start;
  result.first_contact = account.first_contact() == truth.first_contact();
  result.cushions = account.at_cushions() == truth.at_cushions();
  result.pocketed = account.pocketed() == truth.pocketed();
  return result;
}

}  // namespace breakshot::study
