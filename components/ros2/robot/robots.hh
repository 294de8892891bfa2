#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "pongsim/parameters.hh"
#include "pongsim/system.hh"
#include "ros2/bridge/bridge.hh"
#include "ros2/config/settings.hh"
#include "ros2/node/node.hh"
#include "ros2/robot/joint_states.hh"
#include "ros2/robot/rival_publishers.hh"
#include "ros2/robot/robot_descriptions.hh"
#include "ros2/robot/robot_list.hh"
#include "ros2/robot/robot_settings.hh"
#include "ros2/robot/transforms.hh"

namespace pongsim::ros2 {

/// Publishes what ROS expects of robots by default: /robot_description, /joint_states, /tf, /tf_static.
///
/// In a world with one robot the names are these, as all of ROS expects. With several, each has its own
/// /M/robot_description and /M/joint_states, and /joint_states contains the joints of all, as "M/joint". If a rule
/// bridges a topic to one of these names, only that topic is published there.
///
/// For the simulation's thread. Must not outlive its arguments.
class Robots {
 public:
  Robots(const World& world, const Node& simulation, RosNode& ros, Bridge& bridge, const Settings& settings,
         const RobotSettings& robotSettings);

  /// Call when models have been added or removed.
  void worldChanged() { hasChanged_ = true; }
  /// Leaves these ROS topics to others of this process.
  void leave(std::set<std::string> topics);
  void preUpdate(Time now);
  void postUpdate(Time now);
  /// Call when time starts again.
  void reset();

 private:
  void lookForOthers(Time now);
  void follow();
  void nameTopics();
  std::string nameOf(const Robot& robot, const char* topic) const;
  std::string plainName(const char* topic) const;
  bool isRuled(const std::string& rosName) const;

  RosNode& ros_;
  Settings settings_;
  RobotSettings robotSettings_;
  bool hasChanged_ = true;
  bool mustRename_ = false;
  std::set<std::string> left_;
  /// Times to look for other nodes that publish the same.
  Schedule looks_{std::chrono::milliseconds(200)};
  std::uint64_t knownGraph_ = 0;
  RobotList list_;
  JointStates jointStates_;
  RobotDescriptions descriptions_;
  std::optional<Transforms> transforms_;
  RivalPublishers rivals_;
};

}  // namespace pongsim::ros2
