#pragma once

#include <vector>

namespace pongsim::ros2 {

/// How a vehicle with steered wheels moves, by the formulas of steering_controllers_library: traction wheels on one
/// axle, steered wheels on the other. Where there are two wheels, the right one comes first.
struct SteeringKinematics {
  /// [m]
  double wheelRadius = 0;
  /// Between the axles [m].
  double wheelbase = 0;
  /// Between the wheels of an axle [m].
  double tractionTrack = 0;
  double steeringTrack = 0;
  int tractionWheels = 2;
  int steeredWheels = 2;

  struct Wheels {
    /// [rad/s]
    std::vector<double> speeds;
    /// [rad]
    std::vector<double> angles;
  };
  /// @param turnAngle The present steering angle of the middle of the axle, by which the traction wheels' speeds
  /// differ.
  Wheels commands(double linear, double angular, double turnAngle) const;

  /// @return The steering angle of the middle of the axle for these velocities.
  double steeringAngle(double linear, double angular) const;
  /// @return The same for angles of the steered wheels.
  double steeringAngle(const std::vector<double>& angles) const;
  /// @return Forward velocity of the traction axle's middle, for speeds of its wheels [m/s].
  double linearVelocity(const std::vector<double>& speeds, double steeringAngle) const;
  double angularVelocity(double linear, double steeringAngle) const;
};

}  // namespace pongsim::ros2
