#pragma once

#include <map>
#include <string>

#include "ros2/doctor/finding.hh"
#include "ros2/doctor/observation.hh"

namespace pongsim::ros2 {

/// Where the robot's topics and frames are.
struct Expected {
  /// "/" or "/robot1": its topics are /robot1/scan, ...
  std::string nameSpace = "/";
  /// "" or "robot1/": its frames are robot1/base_link, ...
  std::string framePrefix = {};
};

/// Simulated time: one clock, which moves, and which all nodes use.
Findings checkTime(const Observation& seen);
/// Frames by REP 105: one parent and one publisher for each, one tree, and stamps that move.
Findings checkFrames(const Observation& seen, const Expected& expected);
/// The topics of Nav2, slam_toolbox and robot_localization: frames that tf knows, stamps, rates and covariances.
Findings checkTopics(const Observation& seen, const Expected& expected);
/// Commands: somebody drives the robot, by the type that is sent.
Findings checkCommands(const Observation& seen, const Expected& expected);
/// The description and its joints.
Findings checkRobot(const Observation& seen, const Expected& expected);
/// Publishers and subscribers that don't meet, because of their types or their quality of service.
Findings checkMatches(const Observation& seen);
/// All of them.
Findings checkAll(const Observation& seen, const Expected& expected);

/// @return The frame's outermost ancestor, or itself; empty if it is its own ancestor.
std::string rootOf(const std::map<std::string, FrameSeen>& frames, std::string frame);
/// @return Whether a message or another frame refers to it.
bool isKnown(const std::map<std::string, FrameSeen>& frames, const std::string& frame);

/// @return "'a', 'b'"; at most eight of them.
std::string quoted(const std::set<std::string>& names);
/// @return "12.5", without more digits than are of use.
std::string rounded(double value);

}  // namespace pongsim::ros2
