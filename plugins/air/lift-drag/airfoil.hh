#pragma once

#include <numbers>

#include "pongsim/types.hh"

namespace pongsim {

/// The aerodynamic coefficients of a surface.
struct AirfoilSettings {
  /// Slopes of the lift and drag coefficients with the angle of attack, before and after the stall [1/rad].
  double liftSlope = 1;
  double dragSlope = 0.01;
  double liftSlopeStalled = 0;
  double dragSlopeStalled = 1;
  /// Likewise of the moment coefficient.
  double momentSlope = 0;
  double momentSlopeStalled = 0;
  /// Angle of attack at which the flow separates [rad].
  double stallAngle = std::numbers::pi / 2;
  /// Angle of attack in a flow from straight ahead [rad].
  double zeroAngle = 0;
  /// [m^2]
  double area = 1;
  /// Of the fluid [kg/m^3].
  double density = 1.2041;
  /// Unit vectors in the link frame: towards the flow, and in the direction of lift.
  Vector3 forward = Vector3::UnitX();
  Vector3 upward = Vector3::UnitZ();
  /// A body of revolution, not a wing: the flow determines the direction of its lift.
  bool isRound = false;
  /// There is lift and drag in a flow from behind, too.
  bool isReversible = true;
};

/// @return The angle of attack [rad], within a quarter turn, of a surface that moves at `velocity` [m/s].
double angleOfAttack(const AirfoilSettings& airfoil, const Vector3& velocity);

/// @param velocity Of the surface through the fluid, in the link frame [m/s].
/// @param liftOffset Contribution of a control surface to the lift coefficient.
/// @return The force on it in the link frame [N]; zero below 0.01 m/s.
Vector3 airfoilForce(const AirfoilSettings& airfoil, const Vector3& velocity, double liftOffset);

/// @param momentOffset Contribution of a control surface to the moment coefficient.
/// @return The moment about the point of application, in the link frame; zero below 0.01 m/s. As in Gazebo, pressure
/// times area times the coefficient, without a length.
Vector3 airfoilMoment(const AirfoilSettings& airfoil, const Vector3& velocity, double momentOffset);

}  // namespace pongsim
