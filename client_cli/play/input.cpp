#include "client_cli/play/input.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "client_cli/paragraph.hpp"

namespace breakshot::client {
namespace {

using Words = std::vector<std::string>;
using Parsed = std::variant<Input, Misread>;

struct CommandWord {
  const char* name;
  const char* short_name;  ///< or empty
  const char* usage;
  const char* explanation;
  std::optional<Input> (*parse)(const Words& arguments);
};

Words words_of_line(std::string_view line) {
  Words words(1);
  for (const char c : line) {
    if (c == ' ' || c == '\t' || c == '\r') {
      if (!words.back().empty()) words.emplace_back();
    } else {
      words.back() += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::optional<double> number_of(const std::string& word) {
  double value = 0;
  const char* begin = word.c_str() + (word.starts_with('+') ? 1 : 0);
  const char* end = word.c_str() + word.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<physics::BallId> ball_of(const std::string& word) {
  if (word == "cue") return rules::cue_ball;
  std::uint32_t number = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc{} || stop != end || number > 15) return std::nullopt;
  return physics::BallId{number};
}

std::optional<physics::BallId> object_ball_of(const std::string& word) {
  const auto ball = ball_of(word);
  return ball == rules::cue_ball ? std::nullopt : ball;
}

std::optional<physics::PocketId> pocket_of(const Words& words, std::size_t from) {
  std::string text;
  for (std::size_t i = from; i < words.size(); ++i) text += (i > from ? "-" : "") + words[i];
  return client::pocket_of(text);
}

template <class Wish>
std::optional<Input> plain(const Words& arguments) {
  if (!arguments.empty()) return std::nullopt;
  return Wish{};
}

template <class Wish>
std::optional<Input> with_number(const Words& arguments) {
  if (arguments.size() != 1) return std::nullopt;
  const auto number = number_of(arguments[0]);
  if (!number) return std::nullopt;
  return Wish{*number};
}

std::optional<Input> aim_at(const Words& arguments) {
  if (arguments.empty()) return std::nullopt;
  const auto ball = object_ball_of(arguments[0]);
  if (!ball) return std::nullopt;
  if (arguments.size() == 1) return AimAt{*ball, std::nullopt};
  const auto pocket = pocket_of(arguments, 1);
  if (!pocket) return std::nullopt;
  return AimAt{*ball, pocket};
}

std::optional<Input> tip(const Words& arguments) {
  if (arguments == Words{"centre"}) return SetTip{};
  if (arguments.size() != 2) return std::nullopt;
  const auto side = number_of(arguments[0]);
  const auto height = number_of(arguments[1]);
  if (!side || !height) return std::nullopt;
  return SetTip{{*side, *height}};
}

std::optional<Input> call(const Words& arguments) {
  if (arguments == Words{"safety"}) return MakeCall{{std::nullopt, std::nullopt, true}};
  if (arguments == Words{"nothing"}) return MakeCall{};
  if (arguments.size() < 2) return std::nullopt;
  const auto ball = object_ball_of(arguments[0]);
  const auto pocket = pocket_of(arguments, 1);
  if (!ball || !pocket) return std::nullopt;
  return MakeCall{{ball, pocket, false}};
}

std::optional<Input> place(const Words& arguments) {
  if (arguments.size() != 2 && arguments.size() != 3) return std::nullopt;
  const auto ball = arguments.size() == 3 ? ball_of(arguments[0]) : rules::cue_ball;
  const auto x = number_of(arguments[arguments.size() - 2]);
  const auto y = number_of(arguments.back());
  if (!ball || !x || !y) return std::nullopt;
  return PlaceBall{*ball, {*x, *y}};
}

std::optional<Input> choose(const Words& arguments) {
  if (arguments.size() != 1) return std::nullopt;
  const auto number = ball_of(arguments[0]);
  if (!number || physics::number(*number) == 0) return std::nullopt;
  return TakeOption{physics::number(*number)};
}

std::optional<Input> concede(const Words& arguments) {
  if (arguments.empty()) return GiveUp{false};
  if (arguments == Words{"yes"}) return GiveUp{true};
  return std::nullopt;
}

std::optional<Input> help(const Words& arguments) {
  if (arguments.size() > 1) return std::nullopt;
  return AskHelp{arguments.empty() ? "" : arguments[0]};
}

constexpr std::array commands = {
    CommandWord{
        "aim", "a", "aim DEGREES",
        "aim along an angle: 0 is towards the foot of the table, 90 to its left, -90 to its "
        "right",
        with_number<AimAlong>},
    CommandWord{
        "at", "", "at BALL [POCKET]",
        "aim at a ball, full, or so that it goes into a pocket (at 3 foot-left), which also "
        "calls it",
        aim_at},
    CommandWord{"turn", "", "turn DEGREES",
                "turn the aim a little: 0.5 to the left, -0.5 to the right", with_number<TurnBy>},
    CommandWord{"speed", "v", "speed M/S",
                "how fast the cue ball starts, up to 13 m/s; 1 is soft, 3 firm, 8 a break",
                with_number<SetSpeed>},
    CommandWord{"tip", "", "tip SIDE HEIGHT | tip centre",
                "where the tip meets the cue ball, in radii from its centre, at most 0.5 away: "
                "SIDE to your left, negative to your right; HEIGHT above for follow, negative for "
                "draw",
                tip},
    CommandWord{"call", "c", "call BALL POCKET | call safety | call nothing",
                "announce what the shot is for; pockets are foot-left, side-left, head-left, "
                "foot-right, side-right and head-right, or fl, sl, hl, fr, sr, hr",
                call},
    CommandWord{"shoot", "s", "shoot", "strike the cue ball as prepared", plain<ShootNow>},
    CommandWord{"place", "p", "place [BALL] X Y",
                "put a ball in hand there, in metres from the middle of the table: X towards the "
                "foot, Y to the left; in practice any ball",
                place},
    CommandWord{"choose", "", "choose N", "take one of the options that are listed", choose},
    CommandWord{"table", "t", "table", "show the table again", plain<ShowTable>},
    CommandWord{"status", "", "status",
                "say whose turn it is, the score and how your shot is prepared", plain<TellStatus>},
    CommandWord{"invite", "", "invite", "say how somebody else joins or watches",
                plain<TellInvitation>},
    CommandWord{"rerack", "", "rerack",
                "agree to rack again; done when everybody has agreed since the last shot",
                plain<AgreeToRerack>},
    CommandWord{"claim", "", "claim",
                "take the match of an opponent who has been away for too long", plain<ClaimMatch>},
    CommandWord{"concede", "", "concede yes", "give up the match; in practice, leave it", concede},
    CommandWord{"help", "h", "help [COMMAND]", "list the commands, or explain one", help},
    CommandWord{"quit", "q", "quit", "leave the program; a running match keeps your seat",
                plain<LeaveTable>},
};

const CommandWord* command_of(std::string_view word) {
  if (word == "?") word = "help";
  const auto found =
      std::find_if(commands.begin(), commands.end(), [&](const CommandWord& command) {
        return word == command.name || (*command.short_name != '\0' && word == command.short_name);
      });
  return found == commands.end() ? nullptr : &*found;
}

/// A command in the list of all: how it is used, and beside or below that what it does.
std::vector<std::string> help_lines(const CommandWord& command) {
  constexpr std::size_t width = 76;
  const std::string indent(26, ' ');
  std::string usage = "  " + std::string(command.usage);
  if (*command.short_name != '\0') usage += std::string(", ") + command.short_name;
  std::vector<std::string> lines;
  if (usage.size() >= indent.size()) lines.push_back(std::exchange(usage, ""));
  usage.resize(indent.size(), ' ');
  for (auto& line : wrapped(usage + command.explanation, width, indent)) {
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

std::optional<physics::PocketId> pocket_of(std::string_view text) {
  // By PocketId: where along the table, and on which side of it.
  constexpr std::array<std::array<const char*, 2>, 6> names = {{{"head", "right"},
                                                                {"side", "right"},
                                                                {"foot", "right"},
                                                                {"foot", "left"},
                                                                {"side", "left"},
                                                                {"head", "left"}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string along = names[i][0];
    const std::string side = names[i][1];
    if (text == along + '-' + side || text == side + '-' + along || text == along + ' ' + side ||
        text == side + ' ' + along || text == std::string{along[0], side[0]}) {
      return static_cast<physics::PocketId>(i);
    }
  }
  return std::nullopt;
}

Parsed input_of(std::string_view line) {
  Words words = words_of_line(line);
  if (words.empty()) return Nothing{};
  const CommandWord* command = command_of(words[0]);
  if (command == nullptr) {
    return Misread{"There is no command '" + words[0] + "'; help lists those that there are."};
  }
  words.erase(words.begin());
  const auto input = command->parse(words);
  if (input) return *input;
  return Misread{"That takes: " + std::string(command->usage) + " (" + command->explanation + ")."};
}

std::vector<std::string> help_on(std::string_view topic) {
  if (!topic.empty()) {
    const CommandWord* command = command_of(topic);
    if (command == nullptr) return {"There is no command '" + std::string(topic) + "'."};
    return {std::string(command->usage) + ": " + command->explanation + "."};
  }
  std::vector<std::string> lines;
  for (const CommandWord& command : commands) {
    for (auto& line : help_lines(command)) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace breakshot::client
