#include "airfoil.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim::airfoil_test {
namespace {

AirfoilSettings wing() {
  AirfoilSettings settings;
  settings.liftSlope = 5;
  settings.dragSlope = 0.4;
  settings.liftSlopeStalled = -2;
  settings.dragSlopeStalled = 3;
  settings.stallAngle = 0.3;
  settings.area = 2;
  settings.density = 1.2;
  return settings;
}

/// A wing that moves forward and sinks, so that the flow comes from below by that angle.
Vector3 at(double angle, double speed = 10) { return speed * Vector3(std::cos(angle), 0, -std::sin(angle)); }

/// @return Coefficients of drag and lift.
Eigen::Vector2d coefficients(const AirfoilSettings& settings, double angle) {
  const Vector3 force = airfoilForce(settings, at(angle), 0) / (settings.density / 2 * 100 * settings.area);
  const Vector3 ahead = at(angle, 1);
  return {-force.dot(ahead), force.dot(Vector3(-ahead.z(), 0, ahead.x()))};
}

TEST(Airfoil, LiftsWithTheAngleOfAttackUpToTheStall) {
  for (const double angle : {-0.29, -0.1, 0.05, 0.2, 0.29}) {
    EXPECT_NEAR(angleOfAttack(wing(), at(angle)), angle, 1e-9);
    EXPECT_NEAR(coefficients(wing(), angle)[1], 5 * angle, 1e-9);
    EXPECT_NEAR(coefficients(wing(), angle)[0], 0.4 * std::abs(angle), 1e-9);
  }
}

TEST(Airfoil, LosesLiftAndGainsDragAfterTheStall) {
  EXPECT_NEAR(coefficients(wing(), 0.5)[1], 1.5 - 2 * 0.2, 1e-9);
  EXPECT_NEAR(coefficients(wing(), 0.5)[0], 0.12 + 3 * 0.2, 1e-9);
  EXPECT_NEAR(coefficients(wing(), -0.5)[1], -1.5 + 2 * 0.2, 1e-9);
  EXPECT_NEAR(coefficients(wing(), -0.5)[0], 0.12 + 3 * 0.2, 1e-9);
  // the lift ends where it would turn round
  EXPECT_NEAR(coefficients(wing(), 1.4)[1], 0, 1e-9);
  EXPECT_NEAR(coefficients(wing(), -1.4)[1], 0, 1e-9);
}

TEST(Airfoil, HasAnAngleWhereTheFlowComesFromAhead) {
  AirfoilSettings cambered = wing();
  cambered.zeroAngle = 0.1;
  EXPECT_NEAR(coefficients(cambered, 0.15)[1], 5 * 0.25, 1e-9);
}

TEST(Airfoil, GrowsWithTheSquareOfTheSpeed) {
  EXPECT_NEAR(airfoilForce(wing(), at(0.1, 20), 0).norm() / airfoilForce(wing(), at(0.1), 0).norm(), 4, 1e-9);
  EXPECT_TRUE(airfoilForce(wing(), at(0.1, 0.01), 0).isZero(0));
}

// as in Fortress, the coefficients go with the square of the sweep's cosine, and the pressure does so once more
TEST(Airfoil, IsLessInASweptFlow) {
  const double sweep = 0.4;
  const Vector3 swept = std::cos(sweep) * at(0.1) + std::sin(sweep) * Vector3(0, 10, 0);
  const double cosine = std::cos(sweep);
  EXPECT_NEAR((airfoilForce(wing(), swept, 0) - std::pow(cosine, 4) * airfoilForce(wing(), at(0.1), 0)).norm(), 0,
              1e-9);
}

TEST(Airfoil, IsLiftedByAFlap) {
  const Vector3 more = airfoilForce(wing(), at(0), 0.5) - airfoilForce(wing(), at(0), 0);
  EXPECT_NEAR((more - Vector3(0, 0, 0.5 * 60 * 2)).norm(), 0, 1e-9);
}

TEST(Airfoil, HasAMomentAboutItsSpanThatAStallTakesAway) {
  AirfoilSettings turning = wing();
  turning.momentSlope = 0.5;
  turning.momentSlopeStalled = -1;
  const auto moment = [&](double angle) { return airfoilMoment(turning, at(angle), 0.01).y() / -(60 * 2) - 0.01; };
  EXPECT_NEAR(moment(0.2), 0.1, 1e-9);
  EXPECT_NEAR(moment(-0.2), -0.1, 1e-9);
  EXPECT_NEAR(moment(0.4), 0.15 - 0.1, 1e-9);
  EXPECT_NEAR(moment(1.4), 0, 1e-9);
}

TEST(Airfoil, ThatIsNotReversibleNeedsAFlowFromAhead) {
  AirfoilSettings wing1 = wing();
  const Vector3 backward(-10, 0, 1);
  EXPECT_GT(airfoilForce(wing1, backward, 0).norm(), 1);
  wing1.isReversible = false;
  EXPECT_TRUE(airfoilForce(wing1, backward, 0.5).isZero(0));
  EXPECT_TRUE(airfoilMoment(wing1, backward, 0.5).isZero(0));
  EXPECT_GT(airfoilForce(wing1, at(0.1), 0).norm(), 1);
}

TEST(Airfoil, ThatIsRoundLiftsWhereTheFlowTurnsIt) {
  AirfoilSettings body = wing();
  body.isRound = true;
  for (const double roll : {0.0, 1.0, 2.5}) {
    const Eigen::AngleAxisd turn(roll, Vector3::UnitX());
    EXPECT_NEAR((airfoilForce(body, turn * at(0.1), 0) - turn * airfoilForce(wing(), at(0.1), 0)).norm(), 0, 1e-9);
  }
  // from ahead, without a direction to lift to
  EXPECT_TRUE(airfoilForce(body, at(0), 0).isZero(1e-12));
}

}  // namespace
}  // namespace pongsim::airfoil_test
