#pragma once

#include <cstddef>
#include <vector>

#include "pongsim/state/state_archive.hh"

namespace pongsim::ros2 {

/// Mean of the last values.
class WindowMean {
 public:
  /// @param size At least 1.
  explicit WindowMean(std::size_t size = 10) : size_(size) {}
  void add(double value);
  /// @return Zero without values.
  double mean() const;
  void clear() {
    values_.clear();
    next_ = 0;
  }
  void transfer(StateArchive& archive);

 private:
  std::size_t size_;
  std::size_t next_ = 0;
  std::vector<double> values_;
};

/// The pose of a vehicle in the plane, integrated from velocities, with means of the last velocities.
class WheelOdometry {
 public:
  /// @param window Number of velocities that the means are of.
  explicit WheelOdometry(std::size_t window = 10) : linear_(window), angular_(window) {}

  /// Moves along the arc of a circle.
  /// @param linear [m/s]
  /// @param angular [rad/s]
  /// @param dt [s]
  void advance(double linear, double angular, double dt);
  /// Turns, then moves along a straight line, as mecanum_drive_controller does.
  void advanceStraight(double linear, double lateral, double angular, double dt);
  /// Takes these velocities as they are, instead of means.
  void setVelocities(double linear, double lateral, double angular);
  void reset();
  void transfer(StateArchive& archive);

  double x() const { return x_; }
  double y() const { return y_; }
  double heading() const { return heading_; }
  double linear() const { return linearVelocity_; }
  double lateral() const { return lateralVelocity_; }
  double angular() const { return angularVelocity_; }
  /// Adds velocities to the means, and takes these.
  void average(double linear, double angular);

 private:
  double x_ = 0;
  double y_ = 0;
  double heading_ = 0;
  double linearVelocity_ = 0;
  double lateralVelocity_ = 0;
  double angularVelocity_ = 0;
  WindowMean linear_;
  WindowMean angular_;
};

}  // namespace pongsim::ros2
