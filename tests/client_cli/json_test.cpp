#include "client_cli/json.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace breakshot::client {
namespace {

TEST(Json, WritesTheShortestNumbersThatReadBack) {
  EXPECT_EQ(Json(0.1).text(), "0.1");
  EXPECT_EQ(Json(-0.0).text(), "0");
  EXPECT_EQ(Json(1e300).text(), "1e+300");
  EXPECT_EQ(Json(1.0 / 3).text(), "0.3333333333333333");
  EXPECT_EQ(Json(-7).text(), "-7");
  EXPECT_EQ(Json(std::uint64_t{18446744073709551615u}).text(), "18446744073709551615");
}

TEST(Json, HasNoWordForWhatIsNoNumber) {
  EXPECT_EQ(Json(std::numeric_limits<double>::infinity()).text(), "null");
  EXPECT_EQ(Json(std::numeric_limits<double>::quiet_NaN()).text(), "null");
}

TEST(Json, EscapesWhatWouldEndAStringOrALine) {
  EXPECT_EQ(Json("a\"b\\c\nd\te\x01").text(), "\"a\\\"b\\\\c\\nd\\u0009e\\u0001\"");
  EXPECT_EQ(Json("Jos\xc3\xa9").text(), "\"Jos\xc3\xa9\"");
}

TEST(Json, KeepsTheOrderGiven) {
  const Json json = object({{"b", 1}, {"a", array({true, Json(), "x"})}, {"e", object({})}});
  EXPECT_EQ(json.text(), R"({"b":1,"a":[true,null,"x"],"e":{}})");
  EXPECT_EQ(Json(std::optional<int>()).text(), "null");
  EXPECT_EQ(Json(std::optional<int>(3)).text(), "3");
}

}  // namespace
}  // namespace breakshot::client
