#include "client_cli/draw/abilities.hpp"

#include <gtest/gtest.h>

#include <map>

namespace breakshot::client {
namespace {

Environment environment(std::map<std::string, std::string> values) {
  return [values = std::move(values)](const char* name) -> std::optional<std::string> {
    const auto found = values.find(name);
    if (found == values.end()) return std::nullopt;
    return found->second;
  };
}

const std::map<std::string, std::string> xterm = {{"TERM", "xterm-256color"},
                                                  {"LANG", "en_GB.UTF-8"}};

std::map<std::string, std::string> with(std::map<std::string, std::string> values,
                                        const std::string& name, const std::string& value) {
  values[name] = value;
  return values;
}

TEST(Abilities, FollowTheTerminal) {
  const auto colours = [](const std::map<std::string, std::string>& values) {
    return abilities_of(Colour::automatic, true, environment(values)).colours;
  };
  EXPECT_EQ(colours(xterm), ColourDepth::indexed);
  EXPECT_EQ(colours(with(xterm, "COLORTERM", "truecolor")), ColourDepth::direct);
  EXPECT_EQ(colours(with(xterm, "TERM", "xterm-direct")), ColourDepth::direct);
  EXPECT_EQ(colours(with(xterm, "TERM", "dumb")), ColourDepth::none);
}

TEST(Abilities, HonourNoColorUnlessAskedOtherwise) {
  const auto values = with(xterm, "NO_COLOR", "1");
  const auto colours = [&](Colour wish) {
    return abilities_of(wish, true, environment(values)).colours;
  };
  EXPECT_EQ(colours(Colour::automatic), ColourDepth::none);
  EXPECT_EQ(colours(Colour::always), ColourDepth::indexed);
  EXPECT_EQ(abilities_of(Colour::automatic, true, environment(with(xterm, "NO_COLOR", ""))).colours,
            ColourDepth::indexed);
}

TEST(Abilities, AreNoneWithoutATerminal) {
  const Abilities abilities = abilities_of(Colour::automatic, false, environment(xterm));
  EXPECT_FALSE(abilities.interactive);
  EXPECT_EQ(abilities.colours, ColourDepth::none);
  EXPECT_EQ(abilities_of(Colour::always, false, environment(xterm)).colours, ColourDepth::indexed);
  EXPECT_FALSE(abilities_of(Colour::always, true, environment({})).interactive);
}

TEST(Abilities, NeverMeansNever) {
  EXPECT_EQ(
      abilities_of(Colour::never, true, environment(with(xterm, "COLORTERM", "truecolor"))).colours,
      ColourDepth::none);
}

TEST(Abilities, KnowWhetherTheLocaleSpeaksUnicode) {
  const auto unicode = [](std::map<std::string, std::string> values) {
    return abilities_of(Colour::automatic, true, environment(std::move(values))).unicode;
  };
  EXPECT_TRUE(unicode({}));
  EXPECT_TRUE(unicode({{"LANG", "C.utf8"}}));
  EXPECT_FALSE(unicode({{"LANG", "C"}}));
  EXPECT_FALSE(unicode({{"LANG", "de_DE.ISO-8859-1"}}));
  EXPECT_FALSE(unicode({{"LC_ALL", "POSIX"}, {"LANG", "en_US.UTF-8"}}));
  EXPECT_TRUE(unicode({{"LC_ALL", ""}, {"LC_CTYPE", "en_US.UTF-8"}, {"LANG", "C"}}));
}

TEST(TerminalSize, IsWhatTheEnvironmentOrTheTerminalSays) {
  const TerminalSize asked{100, 30};
  EXPECT_EQ(terminal_size(std::nullopt, environment({})), (TerminalSize{80, 24}));
  EXPECT_EQ(terminal_size(asked, environment({})), asked);
  EXPECT_EQ(terminal_size(asked, environment({{"COLUMNS", "60"}, {"LINES", "20"}})),
            (TerminalSize{60, 20}));
  for (const char* bad : {"", "0", "-5", "12x", "1001", "99999999999999999999"}) {
    EXPECT_EQ(terminal_size(asked, environment({{"COLUMNS", bad}})), asked) << bad;
  }
}

}  // namespace
}  // namespace breakshot::client
