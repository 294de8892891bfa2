#include "pongsim/control/differential_odometry.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pongsim {
namespace {

TEST(DifferentialOdometry, StartsAtTheOriginWhateverTheWheelsSay) {
  DifferentialOdometry odometry(1.2, 0.4);
  odometry.update(7, -3, 0.001);
  EXPECT_EQ(odometry.value().x, 0);
  EXPECT_EQ(odometry.value().y, 0);
  EXPECT_EQ(odometry.value().heading, 0);
  EXPECT_EQ(odometry.value().linearVelocity, 0);
}

TEST(DifferentialOdometry, GoesStraightByRadiusTimesAngle) {
  DifferentialOdometry odometry(1.2, 0.4);
  odometry.update(0, 0, 0.1);
  odometry.update(2.5, 2.5, 0.1);
  EXPECT_DOUBLE_EQ(odometry.value().x, 1);
  EXPECT_DOUBLE_EQ(odometry.value().y, 0);
}

TEST(DifferentialOdometry, ClosesACircle) {
  constexpr double kSeparation = 1.2, kRadius = 0.4, kCircle = 3;
  constexpr int kSteps = 360;
  DifferentialOdometry odometry(kSeparation, kRadius);
  double y = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double turned = 2 * std::numbers::pi * i / kSteps;
    odometry.update(turned * (kCircle - kSeparation / 2) / kRadius, turned * (kCircle + kSeparation / 2) / kRadius,
                    0.01);
    y = std::max(y, odometry.value().y);
  }
  EXPECT_NEAR(odometry.value().x, 0, 1e-9);
  EXPECT_NEAR(odometry.value().y, 0, 1e-9);
  EXPECT_NEAR(odometry.value().heading, 2 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(y, 2 * kCircle, 1e-9);
}

TEST(DifferentialOdometry, MeansVelocitiesOverTenSamples) {
  DifferentialOdometry odometry(1, 1);
  double angle = 0;
  odometry.update(angle, angle, 0.1);
  for (int i = 0; i < 5; ++i) odometry.update(angle + 0.1, angle + 0.1, 0.1), angle += 0.1;
  // The first sample, with no motion to compare, counts as one at rest.
  EXPECT_NEAR(odometry.value().linearVelocity, 5.0 / 6.0, 1e-12);
  for (int i = 0; i < 10; ++i) odometry.update(angle + 0.1, angle + 0.1, 0.1), angle += 0.1;
  EXPECT_NEAR(odometry.value().linearVelocity, 1, 1e-12);
}

}  // namespace
}  // namespace pongsim
