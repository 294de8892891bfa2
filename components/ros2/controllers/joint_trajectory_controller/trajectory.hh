#pragma once

#include <cstddef>
#include <vector>

#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim::ros2 {

/// Positions, velocities, accelerations and efforts of several joints at a time; a list that is empty is not given.
struct TrajectoryPoint {
  /// From the start of the trajectory.
  Time time{0};
  std::vector<double> positions = {};
  std::vector<double> velocities = {};
  std::vector<double> accelerations = {};
  std::vector<double> effort = {};

  void transfer(StateArchive& archive);
};

/// A trajectory through points: linear between points without velocities, cubic with velocities, quintic with
/// accelerations too, as joint_trajectory_controller interpolates.
class Trajectory {
 public:
  Trajectory() = default;
  /// @param start Zero: when it begins.
  /// @param points At least one, with rising times.
  Trajectory(Time start, std::vector<TrajectoryPoint> points) : start_(start), points_(std::move(points)) {}

  bool hasBegun() const { return hasBegun_; }
  /// Sets the state from which it goes to the first point. Positions that are not given follow from velocities, and
  /// those from accelerations.
  void begin(Time now, TrajectoryPoint before);

  struct Sample {
    TrajectoryPoint state;
    /// The last point that was reached, or the first.
    std::size_t point = 0;
    /// Whether the last point was reached.
    bool isOver = false;
  };
  /// @param interpolates Whether states between points are interpolated; otherwise that of the next point.
  Sample sample(Time now, bool interpolates) const;

  /// When a point is reached.
  Time timeOf(std::size_t point) const { return start_ + points_[point].time; }
  Time start() const { return start_; }
  const std::vector<TrajectoryPoint>& points() const { return points_; }
  /// @param joints Number of joints that all lists must have.
  void transfer(StateArchive& archive, std::size_t joints);

 private:
  bool hasBegun_ = false;
  Time start_{0};
  Time begun_{0};
  TrajectoryPoint before_;
  std::vector<TrajectoryPoint> points_;
};

}  // namespace pongsim::ros2
