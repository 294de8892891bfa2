#include "dvl_tracking.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim::dvl_tracking_test {
namespace {

TEST(VelocityFit, FindsTheVelocityOfSpeedsAlongBeams) {
  const Vector3 velocity(1, -2, 0.5);
  VelocityFit fit;
  for (const Vector3& axis : {Vector3(0.6, 0, -0.8), Vector3(-0.6, 0, -0.8), Vector3(0, 0.6, -0.8)}) {
    EXPECT_FALSE(fit.solve());
    fit.add(axis, axis.dot(velocity));
  }
  ASSERT_TRUE(fit.solve());
  EXPECT_TRUE(fit.solve()->velocity.isApprox(velocity, 1e-12));
  // a fourth beam that says something else: the middle, by symmetry
  fit.add({0, -0.6, -0.8}, Vector3(0, -0.6, -0.8).dot(velocity + Vector3(0, 0.2, 0)));
  EXPECT_NEAR(fit.solve()->velocity.x(), 1, 1e-12);
  EXPECT_NEAR(fit.solve()->velocity.y(), -1.9, 0.05);
}

TEST(VelocityFit, HasTheCovarianceOfItsGeometry) {
  VelocityFit fit;
  for (const Vector3& axis :
       {Vector3(0.6, 0, -0.8), Vector3(-0.6, 0, -0.8), Vector3(0, 0.6, -0.8), Vector3(0, -0.6, -0.8)}) {
    fit.add(axis, 0);
  }
  const Matrix3 expected = Vector3(1 / 0.72, 1 / 0.72, 1 / 2.56).asDiagonal();
  EXPECT_TRUE(fit.solve()->covariance.isApprox(expected, 1e-12));
}

TEST(VelocityFit, NeedsBeamsThatAreNotInAPlane) {
  VelocityFit fit;
  for (const double x : {-0.6, 0.6, 0.0}) fit.add({x, 0, -std::sqrt(1 - x * x)}, 1);
  EXPECT_FALSE(fit.solve());
}

TEST(RunningVariance, IsThatOfTheNumbers) {
  RunningVariance numbers;
  EXPECT_EQ(numbers.variance(), 0);
  for (const double number : {2.0, 4.0, 4.0, 6.0}) numbers.add(number);
  EXPECT_DOUBLE_EQ(numbers.mean(), 4);
  EXPECT_DOUBLE_EQ(numbers.variance(), 8.0 / 3);
}

}  // namespace
}  // namespace pongsim::dvl_tracking_test
