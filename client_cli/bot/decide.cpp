#include "client_cli/bot/decide.hpp"

#include <algorithm>
#include <stdexcept>

#include "client_cli/bot/candidates.hpp"
#include "client_cli/bot/evaluate.hpp"
#include "common/rules/groups.hpp"

namespace breakshot::bot {
namespace {

struct Considered {
  Candidate candidate;
  Trial trial;
};

/// Of the errors of the hand: apart from the streams of the physics.
constexpr physics::Stream hand_stream{0x68616e64};
/// The last sample of each decision is the stroke itself.
constexpr std::size_t real_sample = 1023;

physics::ShotSeed seed_of(const Effort& effort, std::size_t sample) {
  return {effort.seed, effort.turn * 1024 + static_cast<std::uint32_t>(sample)};
}

/// The candidate as the hand strikes it: the sample decides how far that is off.
Candidate struck(Candidate candidate, const Effort& effort, std::size_t sample) {
  const Hand& hand = effort.hand;
  const auto key = physics::key_of(seed_of(effort, sample), hand_stream);
  const double aside = hand.direction_rad * physics::symmetric(physics::philox({0}, key));
  const double faster = hand.speed_share * physics::symmetric(physics::philox({1}, key));
  if (aside != 0) {
    const Vec2 way = candidate.direction;
    candidate.direction = towards({0, 0}, way + physics::perp(way) * aside);
  }
  candidate.speed_m_s =
      std::clamp(candidate.speed_m_s * (1 + faster), 1e-3, match::max_shot_speed_m_s);
  return candidate;
}

void sort_by_value(std::vector<Considered>& all) {
  std::stable_sort(all.begin(), all.end(), [](const Considered& a, const Considered& b) {
    return a.trial.value > b.trial.value;
  });
}

/// Every candidate played once, the best first.
std::vector<Considered> first_look(const Position& position, const Effort& effort) {
  std::vector<Considered> all;
  for (const Candidate& candidate : candidates_of(position, effort.candidates)) {
    // As aimed: what the shot is meant to do decides what is called.
    const auto trial = try_out(position, candidate, std::nullopt, seed_of(effort, 0));
    if (trial) all.push_back({candidate, *trial});
  }
  sort_by_value(all);
  return all;
}

/// The mean over further seeds and strokes, with the call that was made at first.
double second_look(const Position& position, const Effort& effort, const Considered& considered) {
  double sum = considered.trial.value;
  for (std::size_t sample = 1; sample < effort.samples; ++sample) {
    const auto trial =
        try_out(position, considered.candidate, considered.trial.call, seed_of(effort, sample));
    sum += trial ? trial->value : -1;
  }
  return sum / static_cast<double>(std::max<std::size_t>(effort.samples, 1));
}

match::Choose best_option(const Position& position) {
  const auto& options = position.status.options;
  const auto best =
      std::max_element(options.begin(), options.end(), [&](rules::Option a, rules::Option b) {
        return value_of(position, a) < value_of(position, b);
      });
  return {*best};
}

Decision decision_of(const Position& position, const Considered& chosen, const Effort& effort) {
  const Candidate candidate = struck(chosen.candidate, effort, real_sample);
  Decision decision{std::nullopt,
                    match::Shoot{candidate.direction, candidate.speed_m_s, chosen.trial.call}};
  const physics::Ball* cue = rules::find(position.table, rules::cue_ball);
  if (candidate.place && *candidate.place != cue->position) {
    decision.place = match::Place{rules::cue_ball, *candidate.place};
  }
  return decision;
}

}  // namespace

Decision decide(const Position& position, const Effort& effort) {
  if (!position.status.options.empty()) return {std::nullopt, best_option(position)};
  if (rules::find(position.table, rules::cue_ball) == nullptr) {
    throw std::logic_error("decide: a position without options needs a cue ball");
  }
  if (targets_of(position).empty()) return {std::nullopt, match::Concede{}};

  auto considered = first_look(position, effort);
  // No shot that the physics can bring to an end: nothing better is known than to give up.
  if (considered.empty()) return {std::nullopt, match::Concede{}};
  const Hand& hand = effort.hand;
  if (is_chancy(position.scene) || hand.direction_rad > 0 || hand.speed_share > 0) {
    considered.resize(std::min(considered.size(), std::max<std::size_t>(effort.finalists, 1)));
    for (Considered& one : considered) one.trial.value = second_look(position, effort, one);
    sort_by_value(considered);
  }
  return decision_of(position, considered[std::min(effort.skip, considered.size() - 1)], effort);
}

}  // namespace breakshot::bot
