#pragma once

#include <string>
#include <vector>

#include "pongsim/outcome.hh"
#include "pongsim/state/state_archive.hh"
#include "ros2/controllers/controller_parameters.hh"
#include "ros2/controllers/joint_trajectory_controller/trajectory.hh"
#include "ros2/types/control_actions.hh"

namespace pongsim::ros2 {

/// How far the state of a joint may be from the desired one; zero: any distance.
struct StateTolerance {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;

  /// @param errors An empty list is within.
  bool contains(const TrajectoryPoint& errors, std::size_t joint) const;
  void transfer(StateArchive& archive);
};

/// The tolerances of a trajectory, by joint.
struct TrajectoryTolerances {
  std::vector<StateTolerance> path;
  std::vector<StateTolerance> goal;
  /// Time after the end in which the goal may still be reached [s]; zero: any time.
  double goalTime = 0;

  /// Reads `constraints`.
  static TrajectoryTolerances read(ControllerParameters& parameters, const std::vector<std::string>& joints);
  /// @return Those of a goal, which replace these where it gives them: 0 leaves one as it is, -1 removes it. Why not
  /// for a goal with wrong ones.
  Outcome<TrajectoryTolerances> withThoseOf(const control_msgs::action::FollowJointTrajectory::Goal& request,
                                            const std::vector<std::string>& joints) const;
  void transfer(StateArchive& archive, std::size_t joints);
};

}  // namespace pongsim::ros2
