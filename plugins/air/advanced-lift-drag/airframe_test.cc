#include "airframe.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace pongsim::airframe_test {
namespace {

// span 6 m, chord 1.5 m, and a pressure of 60 Pa at 10 m/s
Airframe plane() {
  return {.area = 6, .aspectRatio = 6, .chord = 1.5, .efficiency = 0.9, .density = 1.2, .stallAngle = 0.35};
}
constexpr double kPressure = 60 * 6;

/// @return A flow of 10 m/s with these angles to the plane: velocity of the plane in its frame, z up.
Vector3 at(double alpha, double beta = 0) {
  // beta is measured against the velocity ahead, not in the plane of lift and drag
  return {10 * std::cos(alpha), -10 * std::cos(alpha) * std::tan(beta), -10 * std::sin(alpha)};
}

/// @return Force in terms of the flow: drag, to the right, lift.
Vector3 inFlow(const Wrench& wrench, double alpha) {
  const Vector3 flight(std::cos(alpha), 0, -std::sin(alpha)), lift(std::sin(alpha), 0, std::cos(alpha));
  return {-wrench.force.dot(flight), -wrench.force.y(), wrench.force.dot(lift)};
}

TEST(Airframe, LiftsWithTheAngleOfAttackAndPaysWithDrag) {
  Airframe airframe = plane();
  airframe.lift0 = 0.2;
  airframe.alpha.lift = 5;
  airframe.drag0 = 0.03;
  for (const double alpha : {-0.05, 0.02, 0.1}) {
    const double lift = 0.2 + 5 * alpha;
    const double drag = 0.03 + lift * lift / (std::numbers::pi * 6 * 0.9);
    // the models before and after the stall are blended over some degrees
    const Vector3 force = inFlow(airframeWrench(airframe, at(alpha), Vector3::Zero(), {}), alpha) / kPressure;
    EXPECT_NEAR(force.z(), lift, 0.025) << alpha;
    EXPECT_NEAR(force.x(), drag, 0.01) << alpha;
    EXPECT_NEAR(force.y(), 0, 1e-12) << alpha;
  }
}

// far beyond the stall: CL = 2 sin^2 cos, and the drag of a plate across the flow
TEST(Airframe, IsAFlatPlateAfterTheStall) {
  Airframe airframe = plane();
  airframe.alpha.lift = 5;
  const double plate = 2 / (1 + std::exp(-0.224 - 0.115 * 6));
  for (const double alpha : {-1.2, 1.0, 1.5}) {
    const Vector3 force = inFlow(airframeWrench(airframe, at(alpha), Vector3::Zero(), {}), alpha) / kPressure;
    const double sine = std::sin(alpha);
    EXPECT_NEAR(force.z(), std::copysign(2 * sine * sine, alpha) * std::cos(alpha), 1e-3) << alpha;
    EXPECT_NEAR(force.x(), plate * sine * sine, 1e-3) << alpha;
  }
}

TEST(Airframe, BlendsBothModelsAtTheStall) {
  Airframe airframe = plane();
  airframe.alpha.lift = 5;
  const double alpha = 0.35, sine = std::sin(alpha);
  // half of each, but for what the other end of the range adds
  const double expected = 0.5 * 5 * alpha + 0.5 * 2 * sine * sine * std::cos(alpha);
  EXPECT_NEAR(inFlow(airframeWrench(airframe, at(alpha), Vector3::Zero(), {}), alpha).z() / kPressure, expected, 1e-3);
}

TEST(Airframe, FeelsItsSideslip) {
  Airframe airframe = plane();
  airframe.beta = {.side = -0.3, .lift = 0.1, .roll = -0.04, .pitch = 0.02, .yaw = 0.1};
  const double beta = 0.2;
  const Wrench wrench = airframeWrench(airframe, at(0, beta), Vector3::Zero(), {});
  EXPECT_NEAR(wrench.force.y() / kPressure, 0.3 * beta, 1e-12);
  EXPECT_NEAR(wrench.force.z() / kPressure, 0.1 * beta, 1e-12);
  // x ahead, y to the left, z up: pitch and yaw are about -y and -z
  EXPECT_NEAR((wrench.torque / kPressure - Vector3(6 * -0.04, -1.5 * 0.02, -6 * 0.1) * beta).norm(), 0, 1e-12);
}

TEST(Airframe, IsDampedByItsRates) {
  Airframe airframe = plane();
  airframe.p = {.drag = 0.1, .side = 0.2, .lift = 0.3, .roll = -0.5, .pitch = 0.05, .yaw = -0.04};
  airframe.q = {.drag = 0.4, .side = 0.5, .lift = 8, .roll = 0.06, .pitch = -12, .yaw = 0.07};
  airframe.r = {.drag = 0.6, .side = 0.7, .lift = 0.8, .roll = 0.08, .pitch = 0.09, .yaw = -0.1};
  // rates about x, -y and -z, times a length by twice the speed
  const std::vector<std::pair<Vector3, SixCoefficients>> cases{
      {Vector3(2, 0, 0), airframe.p}, {Vector3(0, -2, 0), airframe.q}, {Vector3(0, 0, -2), airframe.r}};
  for (const auto& [rates, slope] : cases) {
    const double factor = 2 * (rates.y() != 0 ? 1.5 : 6.0) / 20 * kPressure;
    const Wrench wrench = airframeWrench(airframe, at(0), rates, {});
    EXPECT_NEAR((wrench.force - factor * Vector3(-slope.drag, -slope.side, slope.lift)).norm(), 0, 1e-9);
    EXPECT_NEAR((wrench.torque - factor * Vector3(6 * slope.roll, -1.5 * slope.pitch, -6 * slope.yaw)).norm(), 0, 1e-9);
  }
}

TEST(Airframe, IsSteeredByItsSurfaces) {
  const SixCoefficients control{.drag = 0.01, .side = 0.02, .lift = 0, .roll = 0.03, .pitch = 0.04, .yaw = 0.05};
  const Wrench wrench = airframeWrench(plane(), at(0), Vector3::Zero(), control);
  EXPECT_NEAR((wrench.force / kPressure - Vector3(-0.01, -0.02, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((wrench.torque / kPressure - Vector3(6 * 0.03, -1.5 * 0.04, -6 * 0.05)).norm(), 0, 1e-12);
  // a lift of theirs costs drag, too
  const Wrench flaps = airframeWrench(plane(), at(0), Vector3::Zero(), {.lift = 0.5});
  EXPECT_NEAR(flaps.force.z() / kPressure, 0.5, 1e-12);
  EXPECT_NEAR(flaps.force.x() / kPressure, -0.25 / (std::numbers::pi * 6 * 0.9), 2e-4);
}

TEST(Airframe, HasAMeanChordWhereNoneIsGiven) {
  Airframe airframe = plane();
  airframe.chord = 0;
  // area 6 by span 6
  EXPECT_NEAR(airframeWrench(airframe, at(0), Vector3::Zero(), {.pitch = 1}).torque.y(), -kPressure, 1e-9);
}

TEST(Airframe, IsAtRestWithoutForce) {
  Airframe airframe = plane();
  airframe.lift0 = 1;
  EXPECT_EQ(airframeWrench(airframe, Vector3::Zero(), Vector3(1, 2, 3), {.pitch = 1}).force.norm(), 0);
  EXPECT_EQ(airframeWrench(airframe, Vector3(0, 5, 0), Vector3::Zero(), {.pitch = 1}).torque.norm(), 0);
}

}  // namespace
}  // namespace pongsim::airframe_test
