#include "pongsim/geometry/ball.hh"

#include <gtest/gtest.h>

#include <numbers>

namespace pongsim {
namespace {

TEST(Ball, HasACapBelowAPlane) {
  const Ball ball{2};
  // a cap of height h holds pi h^2 (3 r - h) / 3
  EXPECT_NEAR(ball.below(Vector3::UnitX(), -1.5).volume, std::numbers::pi * 0.25 * (6 - 0.5) / 3, 1e-12);
  EXPECT_NEAR(ball.below(Vector3::UnitX(), 0).volume, std::numbers::pi * 16 / 3, 1e-12);
  // the centroid of half a ball is 3/8 r from its middle
  EXPECT_NEAR((ball.below(Vector3::UnitX(), 0).first / (std::numbers::pi * 16 / 3) - Vector3(-0.75, 0, 0)).norm(), 0,
              1e-12);
}

TEST(Ball, IsWholeBelowAPlaneAboveItAndNothingAboveOneBelowIt) {
  const Ball ball{2};
  for (const double height : {2.0, 3.0}) {
    EXPECT_NEAR(ball.below(Vector3::UnitY(), height).volume, std::numbers::pi * 32 / 3, 1e-12);
    EXPECT_EQ(ball.below(Vector3::UnitY(), height).first, Vector3::Zero());
    EXPECT_EQ(ball.below(Vector3::UnitY(), -height).volume, 0);
    EXPECT_EQ(ball.below(Vector3::UnitY(), -height).first, Vector3::Zero());
  }
}

}  // namespace
}  // namespace pongsim
