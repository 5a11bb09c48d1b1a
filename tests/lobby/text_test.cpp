#include "common/lobby/text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/lobby/code.hpp"
#include "common/lobby/name.hpp"

namespace breakshot::lobby {
namespace {

const std::vector<std::string>& printable() {
  static const std::vector<std::string> texts = {"a", "Ada Lovelace",    "Ærøskøbing", "張三",
                                                 "😀", "\xf4\x8f\xbf\xbf"};
  return texts;
}

const std::vector<std::string>& unprintable_texts() {
  static const std::vector<std::string> texts = {
      "a\nb",
      "\x1b[2J",
      "a\x7f",
      "a\xc2\x9b"
      "b",                // C1 control sequence introducer
      "a\xe2\x80\xae b",  // right-to-left override
      "a\xe2\x80\x8b"
      "b",  // zero-width space
      "\xef\xbb\xbf"
      "a",                // byte order mark
      "a\xe2\x80\xa8 b",  // line separator
  };
  return texts;
}

const std::vector<std::string>& no_utf8() {
  static const std::vector<std::string> texts = {
      "\x80",              // continuation without a lead
      "\xc0\xaf",          // overlong
      "\xe0\x80\xaf",      // overlong
      "\xf0\x80\x80\xaf",  // overlong
      "\xed\xa0\x80",      // surrogate
      "\xf4\x90\x80\x80",  // beyond U+10FFFF
      "\xf8\x88\x80\x80\x80",
      "\xff",
      "a\xe2\x82",  // cut off
  };
  return texts;
}

TEST(Text, PassesWhatPrintsAsItIs) {
  for (const std::string& text : printable()) {
    EXPECT_EQ(text_fault(text), std::nullopt) << text;
    EXPECT_EQ(name_fault(text), std::nullopt) << text;
  }
  EXPECT_EQ(text_fault(""), std::nullopt);
}

TEST(Text, RefusesWhatActsOnATerminal) {
  for (const std::string& text : unprintable_texts()) {
    EXPECT_TRUE(text_fault(text)) << testing::PrintToString(text);
    EXPECT_TRUE(name_fault(text)) << testing::PrintToString(text);
  }
}

TEST(Text, RefusesWhatIsNoUtf8) {
  for (const std::string& text : no_utf8()) {
    EXPECT_EQ(text_fault(text), "a text must be UTF-8") << testing::PrintToString(text);
    EXPECT_EQ(name_fault(text), "a name must be UTF-8 text") << testing::PrintToString(text);
  }
}

TEST(Text, HasALimit) {
  EXPECT_EQ(text_fault(std::string(max_text_bytes, 'x')), std::nullopt);
  EXPECT_TRUE(text_fault(std::string(max_text_bytes + 1, 'x')));
}

TEST(Name, HasALimitInCharactersNotBytes) {
  std::string name;
  for (std::size_t i = 0; i < max_name_length; ++i) name += "😀";
  EXPECT_EQ(name.size(), max_name_bytes);
  EXPECT_EQ(name_fault(name), std::nullopt);
  EXPECT_TRUE(name_fault(name + "x"));
}

TEST(Name, HasNoSpaceAtItsEnds) {
  EXPECT_EQ(name_fault("a b"), std::nullopt);
  EXPECT_TRUE(name_fault(""));
  EXPECT_TRUE(name_fault(" "));
  EXPECT_TRUE(name_fault(" a"));
  EXPECT_TRUE(name_fault("a\xc2\xa0"));
}

TEST(Code, IsReadAsItWasMeant) {
  EXPECT_EQ(code_of("0123456789"), "0123456789");
  EXPECT_EQ(code_of("abcDEFGHjk"), "ABCDEFGHJK");
  EXPECT_EQ(code_of("oOiIlLxyz0"), "001111XYZ0");
}

TEST(Code, IsNothingElse) {
  for (const char* text : {"", "012345678", "01234567890", "012345678u", "012345678U", "01234-6789",
                           "012345678\xc3"}) {
    EXPECT_EQ(code_of(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace breakshot::lobby
