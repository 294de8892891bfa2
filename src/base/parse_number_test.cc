#include "base/parse_number.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pongsim::base {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ParseDouble, ReadsTheFormsThatWorldsUse) {
  EXPECT_EQ(parseDouble("1.5"), 1.5);
  EXPECT_EQ(parseDouble(" -2 \n"), -2);
  EXPECT_EQ(parseDouble("+3e2"), 300);
  EXPECT_EQ(parseDouble(".5"), 0.5);
  EXPECT_EQ(parseDouble("1."), 1);
  EXPECT_EQ(parseDouble("-1.79769e+308"), -1.79769e+308);
  EXPECT_EQ(parseDouble("inf"), kInfinity);
  EXPECT_EQ(parseDouble("-INF"), -kInfinity);
  EXPECT_TRUE(std::isnan(parseDouble("nan").value()));
}

TEST(ParseDouble, RoundsWhatADoubleCannotHold) {
  EXPECT_EQ(parseDouble("1e999"), kInfinity);
  EXPECT_EQ(parseDouble("-1e999"), -kInfinity);
  EXPECT_EQ(parseDouble("1e-999"), 0);
  EXPECT_EQ(parseDouble(std::string(400, '9')), kInfinity);
  EXPECT_EQ(parseDouble("0." + std::string(400, '0') + "1"), 0);
}

TEST(ParseDouble, RefusesWhatIsNotOneNumber) {
  for (const char* text : {"", " ", "abc", "1.5m", "1 2", "+-1", "++1", "0x10", "1,5", "e5", "-"}) {
    EXPECT_FALSE(parseDouble(text).has_value()) << text;
  }
}

TEST(ParseInteger, ReadsIntegersOnly) {
  EXPECT_EQ(parseInteger(" 42 "), 42);
  EXPECT_EQ(parseInteger("-7"), -7);
  EXPECT_EQ(parseInteger("+7"), 7);
  for (const char* text : {"", "1.0", "1e3", "99999999999999999999", "+-1", "7x"}) {
    EXPECT_FALSE(parseInteger(text).has_value()) << text;
  }
}

TEST(ParseDoubles, ReadsAsManyAsThereAre) {
  EXPECT_EQ(parseDoubles(" 1 2.5\t-3\n"), (std::vector<double>{1, 2.5, -3}));
  EXPECT_EQ(parseDoubles(""), std::vector<double>{});
  EXPECT_FALSE(parseDoubles("1 two 3").has_value());
}

}  // namespace
}  // namespace pongsim::base
