#pragma once

#include "pongsim/control/planar_odometry.hh"
#include "pongsim/control/rolling_mean.hh"
#include "pongsim/export.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// Odometry of a robot with two driven wheels or tracks, computed from its wheel angles, starting at the origin.
/// Integrates along circular arcs; velocities are rolling means of ten samples, like ignition-math's DiffDriveOdometry.
class PONGSIM_API DifferentialOdometry {
 public:
  /// @param wheelSeparation Distance between the wheels [m].
  /// @param wheelRadius [m]
  DifferentialOdometry(double wheelSeparation, double wheelRadius)
      : separation_(wheelSeparation), radius_(wheelRadius) {}

  /// @param leftAngle, rightAngle Wheel angles [rad], not wrapped.
  /// @param dt Time since the last call [s], above zero.
  void update(double leftAngle, double rightAngle, double dt);

  void reset() { *this = DifferentialOdometry(separation_, radius_); }

  PlanarOdometry value() const { return {x_, y_, heading_, linear_.mean(), angular_.mean()}; }

  void transfer(StateArchive& archive);

 private:
  double separation_;
  double radius_;
  double x_ = 0;
  double y_ = 0;
  double heading_ = 0;
  double lastLeft_ = 0;
  double lastRight_ = 0;
  bool started_ = false;
  RollingMean<10> linear_;
  RollingMean<10> angular_;
};

}  // namespace pongsim
