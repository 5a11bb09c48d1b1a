#include "client_cli/draw/keys.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace breakshot::client {
namespace {

std::vector<Key> keys_of(KeyDecoder& decoder) {
  std::vector<Key> keys;
  while (const auto key = decoder.next()) keys.push_back(*key);
  return keys;
}

std::vector<Key> keys_of(std::string_view bytes) {
  KeyDecoder decoder;
  decoder.feed(bytes);
  return keys_of(decoder);
}

TEST(Keys, ReadsCharactersOfAnyLength) {
  EXPECT_EQ(keys_of("a\u00e9\u20ac\U0001f3b1"),
            (std::vector<Key>{U'a', U'\u00e9', U'\u20ac', U'\U0001f3b1'}));
}

TEST(Keys, ReadsArrowsInBothModes) {
  EXPECT_EQ(keys_of("\x1b[A\x1b[B\x1bOC\x1bOD"),
            (std::vector<Key>{Special::up, Special::down, Special::right, Special::left}));
  EXPECT_EQ(keys_of("\x1b[H\x1b[F\x1b[5~\x1b[6~\x1b[3~"),
            (std::vector<Key>{Special::home, Special::end, Special::page_up, Special::page_down,
                              Special::delete_}));
}

TEST(Keys, ReadsControlCharacters) {
  EXPECT_EQ(keys_of("\r\n\t\x7f\b"), (std::vector<Key>{Special::enter, Special::enter, Special::tab,
                                                       Special::erase, Special::erase}));
}

TEST(Keys, WaitsForTheRestOfASequence) {
  KeyDecoder decoder;
  for (const char* part : {"\x1b", "[", "\xe2", "\x82"}) {
    if (part[0] == '\xe2') {
      decoder.feed("A");
      EXPECT_EQ(decoder.next(), Key(Special::up));
    }
    decoder.feed(part);
    EXPECT_FALSE(decoder.next());
  }
  decoder.feed("\xac");
  EXPECT_EQ(decoder.next(), Key(U'\u20ac'));
}

TEST(Keys, TakesAnEscapeForTheKeyWhereNothingFollows) {
  KeyDecoder decoder;
  decoder.feed("\x1b");
  EXPECT_FALSE(decoder.next());
  decoder.pause();
  EXPECT_EQ(decoder.next(), Key(Special::escape));
  EXPECT_EQ(keys_of("\x1bq"), (std::vector<Key>{Special::escape, U'q'}));
}

TEST(Keys, SkipsWhatItDoesNotKnow) {
  EXPECT_EQ(keys_of("\x1b[1;5Pa\xff\x01z"), (std::vector<Key>{U'a', U'z'}));
}

TEST(Keys, GivesUpOnEndlessSequences) {
  KeyDecoder decoder;
  decoder.feed("\x1b[" + std::string(max_escape_bytes, '1'));
  EXPECT_FALSE(decoder.next());
  decoder.feed("a");
  EXPECT_EQ(decoder.next(), Key(U'a'));
}

TEST(Keys, ReportsTheEndAfterTheKeysBeforeIt) {
  KeyDecoder decoder;
  decoder.feed("a");
  EXPECT_EQ(decoder.next(), Key(U'a'));
  decoder.close();
  EXPECT_EQ(decoder.next(), Key(Special::closed));
  EXPECT_FALSE(decoder.next());
}

}  // namespace
}  // namespace breakshot::client
