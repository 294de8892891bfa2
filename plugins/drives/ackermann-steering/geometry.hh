#pragma once

#include "pongsim/control/planar_odometry.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// Dimensions of a car [m], and its maximum steering angle [rad].
struct AckermannGeometry {
  double wheelSeparation = 1.0;
  double kingpinWidth = 0.8;
  double wheelBase = 1.0;
  double wheelRadius = 0.2;
  double steeringLimit = 0.5;
};

/// Commands of the wheels: steering angles [rad] and angular velocities [rad/s].
struct AckermannCommand {
  double leftAngle = 0;
  double rightAngle = 0;
  double leftSpeed = 0;
  double rightSpeed = 0;
};

/// @param linear Commanded velocity [m/s].
/// @param angular Commanded turning rate [rad/s]; a turn narrower than the steering allows becomes the narrowest.
AckermannCommand ackermannCommand(const AckermannGeometry& geometry, double linear, double angular);

/// @param angle Commanded steering angle of the middle of the front axle [rad]; limited to what the steering allows.
/// @return The angles of the wheels; no speeds. As in Gazebo, the distance of the steering axes is `wheelSeparation`.
AckermannCommand ackermannAngles(const AckermannGeometry& geometry, double angle);

/// Odometry of a car from the angles of its wheels, with Fortress's formula.
class AckermannOdometry {
 public:
  /// @param leftAngle, rightAngle Angles of the driven wheels [rad], not wrapped.
  /// @param steering Mean steering angle [rad].
  /// @param dt Time since the last call [s], more than zero.
  void update(const AckermannGeometry& geometry, double leftAngle, double rightAngle, double steering, double dt);

  const PlanarOdometry& value() const { return value_; }

  void transfer(StateArchive& archive);

 private:
  PlanarOdometry value_;
  double lastLeft_ = 0;
  double lastRight_ = 0;
  bool started_ = false;
};

}  // namespace pongsim
