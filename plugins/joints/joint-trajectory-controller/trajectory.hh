#pragma once

#include <ignition/msgs/joint_trajectory.pb.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Target of a joint at a point of a trajectory.
struct JointTarget {
  /// [rad or m]
  double position = 0;
  /// [rad/s or m/s]
  double velocity = 0;
  /// Force added to that of the controllers [N m or N].
  double effort = 0;

  void transfer(StateArchive& archive) {
    archive(position);
    archive(velocity);
    archive(effort);
  }
};

/// The points of a JointTrajectory message. They are not interpolated: each is the target from the time of the previous
/// point until its own.
class Trajectory {
 public:
  /// @return What is wrong with it, or nothing.
  static std::optional<std::string> fault(const ignition::msgs::JointTrajectory& message);

  /// An empty trajectory, for `transfer` to fill in.
  Trajectory() = default;
  /// @param message A valid one.
  /// @param start Time to which the points' times are added.
  Trajectory(const ignition::msgs::JointTrajectory& message, Time start);

  const std::vector<std::string>& joints() const { return joints_; }

  /// Advances to the point that is the target at `now`.
  /// @return Whether it is another one than before.
  bool advance(Time now);

  /// Sets `target` for a joint, by its index in `joints()`; values that the point leaves out stay.
  void target(std::size_t joint, JointTarget& target) const;

  /// @return Fraction of the points begun, 0 to 1.
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
