#pragma once

#include "pongsim/export.hh"
#include "pongsim/planar_odometry.hh"
#include "pongsim/rolling_mean.hh"
#include "pongsim/state_archive.hh"

namespace pongsim {

/// Where a robot of two driven wheels, or tracks, believes to be from the angles of its wheels, starting at the origin.
/// Integration along arcs of circles and velocities as rolling means of ten samples, as ignition-math's
/// DiffDriveOdometry.
class PONGSIM_API DifferentialOdometry {
 public:
  /// @param wheelSeparation Distance of the wheels [m].
  /// @param wheelRadius [m]
  DifferentialOdometry(double wheelSeparation, double wheelRadius)
      : separation_(wheelSeparation), radius_(wheelRadius) {}

  /// @param leftAngle, rightAngle Angles of the wheels [rad], not wrapped.
  /// @param dt Time since the last call [s], more than zero.
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
