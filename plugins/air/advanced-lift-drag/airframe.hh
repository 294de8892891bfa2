#pragma once

#include <array>
#include <numbers>

#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// One number for each coefficient of an aircraft: drag, side force, lift, and the moments about the roll, pitch and
/// yaw axes.
struct SixCoefficients {
  double drag = 0;
  double side = 0;
  double lift = 0;
  double roll = 0;
  double pitch = 0;
  double yaw = 0;

  /// Adds `factor` times other coefficients.
  void add(double factor, const SixCoefficients& other);
};

/// The shape of an aircraft, and the derivatives of its coefficients.
struct Airframe {
  /// [m^2]
  double area = 1;
  /// Square of the span divided by the area.
  double aspectRatio = 1;
  /// Mean aerodynamic chord [m]; 0: area divided by span.
  double chord = 0;
  /// Oswald's efficiency factor.
  double efficiency = 1;
  /// Of the air [kg/m^3].
  double density = 1.2041;
  /// Angle of attack at which the wing stalls [rad].
  double stallAngle = std::numbers::pi / 2;
  /// Coefficients at an angle of attack of zero.
  double lift0 = 0;
  double drag0 = 0;
  /// Derivatives with the angle of attack and the sideslip [1/rad], and with the rates about the roll, pitch and yaw
  /// axes, made dimensionless by span or chord and twice the speed.
  SixCoefficients alpha = {}, beta = {}, p = {}, q = {}, r = {};
  /// Unit vectors in the link frame: towards the flow, and in the direction of lift.
  Vector3 forward = Vector3::UnitX();
  Vector3 upward = Vector3::UnitZ();
};

/// Forces of an aircraft in a quasi-steady flow, with the coefficients of an Athena Vortex Lattice model (M. Drela) up
/// to the stall and those of a flat plate beyond (C. Ostowari and D. Naik, Post-Stall Wind Tunnel Data for NACA 44XX
/// Series Airfoil Sections, 1985), like Gazebo's AdvancedLiftDrag.
/// @param velocity Of the reference point through the air, in the link frame [m/s].
/// @param rates Angular velocity in the link frame [rad/s]; as in Gazebo, its x, -y and -z are the roll, pitch and yaw
/// rates.
/// @param control Sum of the coefficients of the control surfaces.
/// @return Force and torque at the reference point, in the link frame.
Wrench airframeWrench(const Airframe& airframe, const Vector3& velocity, const Vector3& rates,
                      const SixCoefficients& control);

}  // namespace pongsim
