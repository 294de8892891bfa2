#pragma once

#include <string>
#include <vector>

#include "pongsim/outcome.hh"
#include "ros2/controllers/joint_trajectory_controller/trajectory.hh"
#include "ros2/types/trajectory_msgs.hh"

namespace pongsim::ros2 {

/// What a trajectory must be.
struct TrajectoryRules {
  std::vector<std::string> joints;
  bool allowsPartial = false;
  bool allowsIntegration = false;
  bool allowsVelocityAtEnd = false;
  bool takesEffort = false;
};

/// Reads a message, with its joints in any order.
/// @param held Positions of joints that it leaves out.
/// @return Why it is refused, for one that does not follow the rules.
Outcome<Trajectory> readTrajectory(const trajectory_msgs::JointTrajectory& message, const TrajectoryRules& rules,
                                   const std::vector<double>& held, Time now);

}  // namespace pongsim::ros2
