#pragma once

#include <vector>

#include <Eigen/Core>

#include "pongsim/types.hh"
#include "rotors.hh"

namespace pongsim {

/// Mass [kg] and inertia about the centre of mass, in the axes of the body [kg m^2], of everything that the rotors
/// lift.
struct VehicleMass {
  double mass = 0;
  Matrix3 inertia = Matrix3::Zero();
};

struct LeeGains {
  /// World axes [N s/m].
  Vector3 velocity = Vector3::Zero();
  /// Body axes [N m/rad].
  Vector3 attitude = Vector3::Zero();
  /// Body axes [N m s/rad].
  Vector3 angularRate = Vector3::Zero();
  /// Limit of the acceleration due to the velocity error, world axes [m/s^2].
  Vector3 maximumAcceleration = Vector3::Zero();
};

/// Orientation and velocity of a body.
struct BodyMotion {
  /// From body axes to world axes.
  Matrix3 R_WorldBody = Matrix3::Identity();
  /// World frame [m/s].
  Vector3 velocity = Vector3::Zero();
  /// Body frame [rad/s].
  Vector3 angularVelocity = Vector3::Zero();
};

/// Target velocity and yaw rate of a body.
struct VelocityCommand {
  /// Body frame [m/s].
  Vector3 velocity = Vector3::Zero();
  /// About the body's z axis [rad/s].
  double yawRate = 0;
};

/// The rotor speeds for a given velocity and yaw rate: the attitude controller of T. Lee, M. Leok and N. H. McClamroch,
/// Control of Complex Maneuvers for a Quadrotor UAV using Geometric Methods on SE(3), 2010, with a velocity instead of
/// a position, as in Fortress.
class LeeVelocityController {
 public:
  /// @param vehicle With an invertible inertia.
  /// @param allocation Of rank 4.
  LeeVelocityController(const LeeGains& gains, const VehicleMass& vehicle, const Allocation& allocation);

  /// Writes the rotor speeds into `speeds` [rad/s], none below zero.
  /// @param gravity World frame [m/s^2].
  void compute(const BodyMotion& motion, const VelocityCommand& command, const Vector3& gravity,
               std::vector<double>& speeds) const;

 private:
  Vector3 acceleration(const BodyMotion& motion, const VelocityCommand& command, const Vector3& gravity) const;
  Vector3 angularAcceleration(const BodyMotion& motion, double yawRate, const Vector3& acceleration) const;

  LeeGains gains_;
  double mass_;
  /// Gains for angular accelerations instead of torques.
  Vector3 attitudeGain_;
  Vector3 angularRateGain_;
  /// From angular accelerations and thrust to squares of speeds.
  Eigen::Matrix<double, Eigen::Dynamic, 4> toSquares_;
};

}  // namespace pongsim
