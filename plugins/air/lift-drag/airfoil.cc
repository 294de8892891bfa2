#include "airfoil.hh"

#include <algorithm>
#include <cmath>

#include "pongsim/math.hh"

namespace pongsim {

namespace {

constexpr double kSlowest = 0.01;

/// The flow relative to the surface.
struct Flow {
  /// Unit vector normal to the plane of lift and drag.
  Vector3 span;
  /// Velocity in that plane [m/s].
  Vector3 velocity;
  /// Unit vector perpendicular to the velocity, in that plane.
  Vector3 lift;
  /// Angle of attack [rad].
  double angle = 0;
};

double withinQuarterTurn(double angle) {
  // large angles would take many turns
  angle = std::remainder(angle, 2 * std::numbers::pi);
  while (std::abs(angle) > std::numbers::pi / 2) angle += angle > 0 ? -std::numbers::pi : std::numbers::pi;
  return angle;
}

Flow flowAround(const AirfoilSettings& airfoil, const Vector3& velocity) {
  Vector3 upward = airfoil.upward;
  if (airfoil.isRound) upward = airfoil.forward.cross(airfoil.forward.cross(velocity)).normalized();
  Flow flow;
  flow.span = airfoil.forward.cross(upward).normalized();
  flow.velocity = velocity - velocity.dot(flow.span) * flow.span;
  flow.lift = flow.span.cross(flow.velocity).normalized();
  flow.angle = airfoil.zeroAngle;
  // a body of revolution in a flow from straight ahead has no lift
  if (!flow.span.isZero(0)) {
    const double turn = math::acos(std::clamp(flow.lift.dot(upward), -1.0, 1.0));
    flow.angle += flow.lift.dot(airfoil.forward) >= 0 ? turn : -turn;
  }
  flow.angle = withinQuarterTurn(flow.angle);
  return flow;
}

/// A coefficient that is linear with one slope up to the stall, and with another beyond it.
double coefficient(double angle, double stall, double slope, double slopeStalled) {
  if (angle > stall) return slope * stall + slopeStalled * (angle - stall);
  if (angle < -stall) return -slope * stall + slopeStalled * (angle + stall);
  return slope * angle;
}

/// @return Whether the flow is too slow, or from behind, for any force.
bool isWithoutForce(const AirfoilSettings& airfoil, const Vector3& velocity) {
  if (!(velocity.norm() > kSlowest)) return true;
  return !airfoil.isReversible && airfoil.forward.dot(velocity) <= 0;
}

/// @return The square of the sweep angle's cosine, by which Fortress multiplies coefficients.
double sweepFactor(const Flow& flow, const Vector3& velocity) {
  const double sine = std::clamp(flow.span.dot(velocity) / velocity.norm(), -1.0, 1.0);
  return 1 - sine * sine;
}

/// @return A coefficient of lift or moment: a stall takes it away, but does not reverse it.
double stalling(const AirfoilSettings& airfoil, double angle, double slope, double slopeStalled) {
  const double value = coefficient(angle, airfoil.stallAngle, slope, slopeStalled);
  if (angle > airfoil.stallAngle) return std::max(0.0, value);
  if (angle < -airfoil.stallAngle) return std::min(0.0, value);
  return value;
}

}  // namespace

double angleOfAttack(const AirfoilSettings& airfoil, const Vector3& velocity) {
  return flowAround(airfoil, velocity).angle;
}

Vector3 airfoilForce(const AirfoilSettings& airfoil, const Vector3& velocity, double liftOffset) {
  if (isWithoutForce(airfoil, velocity)) return Vector3::Zero();
  const Flow flow = flowAround(airfoil, velocity);
  const double sweep = sweepFactor(flow, velocity);
  const double pressure = airfoil.density / 2 * flow.velocity.squaredNorm();
  const double lift = stalling(airfoil, flow.angle, airfoil.liftSlope, airfoil.liftSlopeStalled) * sweep + liftOffset;
  const double drag =
      std::abs(coefficient(flow.angle, airfoil.stallAngle, airfoil.dragSlope, airfoil.dragSlopeStalled) * sweep);
  return pressure * airfoil.area * (lift * flow.lift - drag * flow.velocity.normalized());
}

Vector3 airfoilMoment(const AirfoilSettings& airfoil, const Vector3& velocity, double momentOffset) {
  const bool hasMoment = airfoil.momentSlope != 0 || airfoil.momentSlopeStalled != 0 || momentOffset != 0;
  if (!hasMoment || isWithoutForce(airfoil, velocity)) return Vector3::Zero();
  const Flow flow = flowAround(airfoil, velocity);
  const double pressure = airfoil.density / 2 * flow.velocity.squaredNorm();
  const double moment =
      stalling(airfoil, flow.angle, airfoil.momentSlope, airfoil.momentSlopeStalled) * sweepFactor(flow, velocity) +
      momentOffset;
  return pressure * airfoil.area * moment * flow.span;
}

}  // namespace pongsim
