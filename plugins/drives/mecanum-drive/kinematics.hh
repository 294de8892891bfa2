#pragma once

#include "pongsim/control/planar_odometry.hh"
#include "pongsim/control/rolling_mean.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// Dimensions of a mecanum drive [m].
struct MecanumGeometry {
  /// Distance between left and right wheels.
  double wheelSeparation = 1;
  /// Distance between front and rear wheels.
  double wheelbase = 1;
  double wheelRadius = 0.2;
};

/// A value for each wheel: speeds [rad/s] or angles [rad].
struct MecanumWheels {
  double frontLeft = 0;
  double frontRight = 0;
  double backLeft = 0;
  double backRight = 0;
};

/// A velocity in the plane: forward and to the left [m/s], anticlockwise [rad/s]; or a displacement [m, rad].
struct PlanarTwist {
  double x = 0;
  double y = 0;
  double yaw = 0;
};

/// @return The speeds of wheels whose rollers are at 45 degrees, in an X seen from above (H. Taheri, B. Qiao and N.
/// Ghaeminezhad, "Kinematic Model of a Four Mecanum Wheeled Mobile Robot", Int. J. of Computer Applications 113(3),
/// 2015).
MecanumWheels wheelsFor(const MecanumGeometry& geometry, const PlanarTwist& twist);

/// @return The vehicle's velocity for given wheel speeds, the inverse of the above; the mean if the wheels contradict
/// each other.
PlanarTwist twistOf(const MecanumGeometry& geometry, const MecanumWheels& wheels);

/// Odometry from the angles of the wheels, starting at the origin; velocities are rolling means of ten samples.
class MecanumOdometry {
 public:
  /// @param angles Of the wheels [rad], not wrapped.
  /// @param dt Time since the last call [s], more than zero.
  void update(const MecanumGeometry& geometry, const MecanumWheels& angles, double dt);

  PlanarOdometry value() const { return {x_, y_, heading_, forward_.mean(), angular_.mean(), lateral_.mean()}; }

  void transfer(StateArchive& archive);

 private:
  double x_ = 0;
  double y_ = 0;
  double heading_ = 0;
  MecanumWheels last_;
  bool started_ = false;
  RollingMean<10> forward_;
  RollingMean<10> lateral_;
  RollingMean<10> angular_;
};

}  // namespace pongsim
