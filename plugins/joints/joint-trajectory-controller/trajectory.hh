#pragma once

#include <ignition/msgs/joint_trajectory.pb.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// What a joint is to do at a point of a trajectory.
struct JointTarget {
  /// [rad or m]
  double position = 0;
  /// [rad/s or m/s]
  double velocity = 0;
  /// Force beside what it takes to get there [N m or N].
  double effort = 0;

  void transfer(StateArchive& archive) {
    archive(position);
    archive(velocity);
    archive(effort);
  }
};

/// A list of points to be at one after another, as a message asks for. There is nothing between two points: each one
/// counts from the time of the one before it until its own.
class Trajectory {
 public:
  /// @return What is wrong with it, or nothing.
  static std::optional<std::string> fault(const ignition::msgs::JointTrajectory& message);

  /// One without points, for `transfer` to fill in.
  Trajectory() = default;
  /// @param message Without a fault.
  /// @param start Time from which its points count.
  Trajectory(const ignition::msgs::JointTrajectory& message, Time start);

  const std::vector<std::string>& joints() const { return joints_; }

  /// Goes on to the point that counts at `now`.
  /// @return Whether that is another one than before.
  bool advance(Time now);

  /// Changes `target` to what the point says of the joint in that place of `joints()`; what it does not say stays.
  void target(std::size_t joint, JointTarget& target) const;

  /// @return The point that counts and all before it, of all [0 to 1].
  double progress() const;

  void transfer(StateArchive& archive);

 private:
  struct Point {
    Time time;
    std::vector<double> positions, velocities, efforts;

    void transfer(StateArchive& archive) {
      archive(time);
      archive(positions);
      archive(velocities);
      archive(efforts);
    }
  };

  std::vector<std::string> joints_;
  std::vector<Point> points_;
  Time start_{0};
  std::size_t current_ = 0;
  bool started_ = false;
};

}  // namespace pongsim
