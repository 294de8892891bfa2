#pragma once

#include <numbers>

#include "pongsim/types.hh"

namespace pongsim {

/// What the flow does to a surface of a certain shape.
struct AirfoilSettings {
  /// Slopes of the coefficients of lift and drag over the angle of attack, before and after the stall [1/rad].
  double liftSlope = 1;
  double dragSlope = 0.01;
  double liftSlopeStalled = 0;
  double dragSlopeStalled = 1;
  /// Angle of attack from which the flow is torn off [rad].
  double stallAngle = std::numbers::pi / 2;
  /// Angle of attack where the flow comes from ahead [rad].
  double zeroAngle = 0;
  /// [m^2]
  double area = 1;
  /// Of the fluid [kg/m^3].
  double density = 1.2041;
  /// Unit vectors in the link frame: where the flow comes from, and where the lift goes.
  Vector3 forward = Vector3::UnitX();
  Vector3 upward = Vector3::UnitZ();
  /// A body, not a wing: the lift goes where the flow turns it.
  bool isRound = false;
};

/// @return The angle of attack [rad], within a quarter turn, of a surface that moves at `velocity` [m/s].
double angleOfAttack(const AirfoilSettings& airfoil, const Vector3& velocity);

/// @param velocity Of the surface through the fluid, in the link frame [m/s].
/// @param liftOffset What a control surface adds to the coefficient of lift.
/// @return The force on it in the link frame [N]; zero below 0.01 m/s.
Vector3 airfoilForce(const AirfoilSettings& airfoil, const Vector3& velocity, double liftOffset);

}  // namespace pongsim
