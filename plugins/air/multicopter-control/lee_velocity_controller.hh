#pragma once

#include <vector>

#include <Eigen/Core>

#include "pongsim/types.hh"
#include "rotors.hh"

namespace pongsim {

/// Mass [kg] and inertia about the centre of mass, in the axes of the body [kg m^2], of what the rotors carry.
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
  /// Largest acceleration that the velocity asks for, world axes [m/s^2].
  Vector3 maximumAcceleration = Vector3::Zero();
};

/// How a body flies.
struct BodyMotion {
  /// From the axes of the body to those of the world.
  Matrix3 R_WorldBody = Matrix3::Identity();
  /// World frame [m/s].
  Vector3 velocity = Vector3::Zero();
  /// Body frame [rad/s].
  Vector3 angularVelocity = Vector3::Zero();
};

/// What a body is to fly like.
struct VelocityCommand {
  /// Body frame [m/s].
  Vector3 velocity = Vector3::Zero();
  /// About the body's z axis [rad/s].
  double yawRate = 0;
};

/// The speeds of the rotors that give a body the velocity and the yaw rate that are asked for: the attitude controller
/// of T. Lee, M. Leok and N. H. McClamroch, Control of Complex Maneuvers for a Quadrotor UAV using Geometric Methods on
/// SE(3), 2010, with a velocity in place of a position, as Fortress has it.
class LeeVelocityController {
 public:
  /// @param vehicle With an inertia that can be inverted.
  /// @param allocation Of rank 4.
  LeeVelocityController(const LeeGains& gains, const VehicleMass& vehicle, const Allocation& allocation);

  /// Replaces `speeds` by those of the rotors [rad/s], none below zero.
  /// @param gravity World frame [m/s^2].
  void compute(const BodyMotion& motion, const VelocityCommand& command, const Vector3& gravity,
               std::vector<double>& speeds) const;

 private:
  Vector3 acceleration(const BodyMotion& motion, const VelocityCommand& command, const Vector3& gravity) const;
  Vector3 angularAcceleration(const BodyMotion& motion, double yawRate, const Vector3& acceleration) const;

  LeeGains gains_;
  double mass_;
  /// Gains for an angular acceleration, in place of a torque.
  Vector3 attitudeGain_;
  Vector3 angularRateGain_;
  /// From angular accelerations and thrust to squares of speeds.
  Eigen::Matrix<double, Eigen::Dynamic, 4> toSquares_;
};

}  // namespace pongsim
