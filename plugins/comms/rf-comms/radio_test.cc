#include "radio.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>

namespace pongsim::radio_test {
namespace {

using std::chrono::milliseconds;

TEST(Radio, LosesPowerWithTheLogarithmOfTheDistance) {
  const RadioSettings settings;
  EXPECT_DOUBLE_EQ(meanReceivedPower(settings, 1), 27 - 40);
  EXPECT_DOUBLE_EQ(meanReceivedPower(settings, 10), 27 - 40 - 25);
  EXPECT_NEAR(meanReceivedPower(settings, 20) - meanReceivedPower(settings, 40), 25 * std::log10(2), 1e-12);
  EXPECT_TRUE(std::isfinite(meanReceivedPower(settings, 50)));
  EXPECT_EQ(meanReceivedPower(settings, 50.001), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isfinite(meanReceivedPower({.maxRange = 0}, 1e6))) << "there is no limit";
}

TEST(Radio, MakesErrorsByTheShareOfNoise) {
  const RadioSettings settings;
  // erfc(1): as much power as noise
  EXPECT_NEAR(bitErrorRate(settings, -90), 0.15729920705, 1e-9);
  // erfc(sqrt(10)): 10 dB more
  EXPECT_NEAR(bitErrorRate(settings, -80), 7.744216431e-6, 1e-12);
  EXPECT_EQ(bitErrorRate(settings, -std::numeric_limits<double>::infinity()), 1);
  EXPECT_EQ(bitErrorRate(settings, std::numeric_limits<double>::infinity()), 0);
}

TEST(Radio, LosesPacketsByTheirBytes) {
  EXPECT_NEAR(lossProbability(0.1, 1), 0.1, 1e-15);
  EXPECT_NEAR(lossProbability(0.1, 3), 1 - 0.9 * 0.9 * 0.9, 1e-15);
  // what 1 - exp(n log(1 - p)) would round away
  EXPECT_NEAR(lossProbability(1e-18, 100), 1e-16, 1e-30);
  EXPECT_EQ(lossProbability(1, 10), 1);
  EXPECT_EQ(lossProbability(1, 0), 1);
  EXPECT_EQ(lossProbability(0.5, 0), 0);
}

TEST(RateWindow, LetsThroughWhatFitsIntoASecond) {
  RateWindow window;
  EXPECT_EQ(window.add(milliseconds(0), 50, 800), std::nullopt);
  EXPECT_EQ(window.add(milliseconds(500), 50, 800), std::nullopt);
  EXPECT_EQ(window.add(milliseconds(999), 1, 800), 808);
  EXPECT_EQ(window.add(milliseconds(1000), 50, 800), std::nullopt) << "the first one is a second ago";
  EXPECT_EQ(window.add(milliseconds(1499), 1, 800), 808);
  EXPECT_EQ(window.add(milliseconds(9000), 100, 800), std::nullopt);
}

}  // namespace
}  // namespace pongsim::radio_test
