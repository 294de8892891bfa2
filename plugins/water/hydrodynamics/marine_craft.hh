#pragma once

#include <array>

#include <Eigen/Core>

namespace pongsim {

/// Velocity of a craft through the water in its own frame, u v w p q r [m/s, rad/s], or forces and torques on it.
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Hydrodynamic forces on a craft (T. I. Fossen, Guidance and Control of Ocean Vehicles, 1994), with the signs of its
/// stability derivatives: drag and added mass are negative.
struct MarineCraft {
  /// Added mass: X_udot and so on, row by row [kg, kg m, kg m^2].
  Matrix6 addedMass = Matrix6::Zero();
  /// X_u and so on.
  Matrix6 linear = Matrix6::Zero();
  /// X_u|u| and so on: entry k of i and j is multiplied by v_j |v_k|.
  std::array<Matrix6, 6> quadraticAbs{};
  /// Likewise by v_j v_k.
  std::array<Matrix6, 6> quadratic{};

  MarineCraft();

  /// @return Force and torque on it, from its velocity and acceleration.
  Vector6 addedMassForce(const Vector6& acceleration) const { return addedMass * acceleration; }
  /// @return The Coriolis forces of the added mass. Only the diagonal of the added mass counts, as in Fortress.
  Vector6 coriolisForce(const Vector6& velocity) const;
  Vector6 dampingForce(const Vector6& velocity) const;
};

}  // namespace pongsim
