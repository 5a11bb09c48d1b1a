#include "client_cli/words.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <type_traits>

namespace breakshot::client {
namespace {

template <class Enum, std::size_t N>
std::string pick(const std::array<const char*, N>& words, Enum value) {
  const auto index = static_cast<std::size_t>(value);
  return index < N ? words[index] : "unknown (" + std::to_string(index) + ")";
}

std::string number_of(physics::BallId ball) {
  return ball == rules::cue_ball ? "the cue ball" : std::to_string(number(ball));
}

std::string words_of_contact(const physics::BallBall& contact) {
  return words_of(contact.lower) + " and " + words_of(contact.higher) + " collide";
}

}  // namespace

Names names_of(const record::Header& header) {
  Names names;
  for (const record::Player& player : header.players) names.push_back(player.name);
  return names;
}

std::string name_of(const Names& names, rules::Seat seat) {
  const std::size_t index = rules::number(seat);
  if (index < names.size() && !names[index].empty()) return names[index];
  return "player " + std::to_string(index + 1);
}

std::string words_of(physics::BallId ball) {
  if (ball == rules::cue_ball) return "cue ball";
  return std::to_string(number(ball)) + " ball";
}

std::string words_of(physics::PocketId pocket) {
  static constexpr std::array<const char*, 6> words = {"head right corner", "right side",
                                                       "foot right corner", "foot left corner",
                                                       "left side",         "head left corner"};
  return pick(words, pocket);
}

std::string words_of(rules::Group group) {
  static constexpr std::array<const char*, 3> words = {"an open table", "solids", "stripes"};
  return pick(words, group);
}

std::string words_of(rules::Foul foul) {
  static constexpr std::array<const char*, 5> words = {
      "the cue ball was pocketed", "the cue ball hit no ball",
      "the first ball hit was not one of the shooter's",
      "no ball was pocketed or reached a cushion after the contact",
      "the shot from behind the head string was not legal"};
  return pick(words, foul);
}

std::string words_of(rules::Option option) {
  static constexpr std::array<const char*, 6> words = {
      "accept the table",
      "take ball in hand behind the head string",
      "rack again and break",
      "have the balls racked and the opponent break again",
      "have the 8 ball spotted and go on",
      "have the ball nearest the head string spotted"};
  return pick(words, option);
}

std::string words_of(match::GameKind game) {
  static constexpr std::array<const char*, 2> words = {"8-ball", "practice"};
  return pick(words, game);
}

std::string words_of(match::MatchId id) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx",
                static_cast<unsigned long long>(static_cast<std::uint64_t>(id)));
  return text.data();
}

std::string words_of(const rules::Call& call) {
  if (call.safety) return "safety";
  if (!call.ball || !call.pocket) return {};
  return words_of(*call.ball) + " in the " + words_of(*call.pocket);
}

std::string words_of(const physics::Tip& tip) {
  const auto part = [](double radii, const char* positive, const char* negative) {
    if (radii == 0) return std::string();
    char text[32];
    std::snprintf(text, sizeof text, "%.2f R ", std::abs(radii));
    return text + std::string(radii > 0 ? positive : negative);
  };
  const std::string side = part(tip.side, "left of", "right of");
  const std::string height = part(tip.height, "above", "below");
  if (side.empty() && height.empty()) return {};
  return side + (side.empty() || height.empty() ? "" : " and ") + height + " the centre";
}

std::string balls_in_words(const std::vector<physics::BallId>& balls) {
  std::string text;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (i > 0) text += i + 1 == balls.size() ? " and " : ", ";
    text += number_of(balls[i]);
  }
  return text;
}

std::string words_of(const physics::Event& event) {
  return std::visit(
      [](const auto& e) -> std::string {
        using Kind = std::decay_t<decltype(e)>;
        if constexpr (std::is_same_v<Kind, physics::Struck>) {
          return words_of(e.ball) + " is struck";
        } else if constexpr (std::is_same_v<Kind, physics::BallBall>) {
          return words_of_contact(e);
        } else if constexpr (std::is_same_v<Kind, physics::BallCushion>) {
          return words_of(e.ball) + " reaches cushion " + std::to_string(number(e.cushion));
        } else if constexpr (std::is_same_v<Kind, physics::BallPocket>) {
          return words_of(e.ball) + " drops in the " + words_of(e.pocket);
        } else if constexpr (std::is_same_v<Kind, physics::Rolls>) {
          return words_of(e.ball) + " begins to roll";
        } else if constexpr (std::is_same_v<Kind, physics::Spins>) {
          return words_of(e.ball) + " spins in place";
        } else {
          static_assert(std::is_same_v<Kind, physics::Rests>);
          return words_of(e.ball) + " comes to rest";
        }
      },
      event);
}

}  // namespace breakshot::client
