#include "sonar_link.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim::sonar_link_test {
namespace {

TEST(SonarLink, HasTheRatioOfTheSonarEquation) {
  // 170.8 + 10 log10(2000) - 20 log10(100) - 1
  EXPECT_NEAR(signalToNoise({}, 100), 170.8 + 33.0103 - 40 - 1, 1e-4);
  EXPECT_NEAR(signalToNoise({.sourcePower = 1, .noiseLevel = 0}, 1), 170.8, 1e-9);
}

TEST(SonarLink, LosesPacketsByTheirSize) {
  EXPECT_NEAR(packetLoss({}, 100, 1000), 0, 1e-200);
  // a ratio of 0 dB, so that each second bit is wrong
  const SonarLinkSettings faint{.sourcePower = 1, .noiseLevel = 170.8 - 40};
  EXPECT_NEAR(packetLoss(faint, 100, 1), 0.5, 1e-9);
  EXPECT_NEAR(packetLoss(faint, 100, 3), 0.875, 1e-9);
  EXPECT_EQ(packetLoss(faint, 100, 0), 0);
  // one of 7 dB
  EXPECT_NEAR(packetLoss({.sourcePower = 1, .noiseLevel = 170.8 - 47}, 100, 10), 1 - std::pow(1 - std::erfc(1) / 2, 10),
              1e-9);
  EXPECT_EQ(packetLoss({.sourcePower = 1e-300, .noiseLevel = 1e4}, 1e6, 1), 1);
}

}  // namespace
}  // namespace pongsim::sonar_link_test
