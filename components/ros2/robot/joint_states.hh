#pragma once

#include <list>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/parameters.hh"
#include "ros2/node/node.hh"
#include "ros2/pairs/frames.hh"
#include "ros2/robot/robot_list.hh"
#include "ros2/robot/stamps.hh"
#include "ros2/types/sensor_msgs.hh"

namespace pongsim::ros2 {

/// Publishes the joint states of robots: for joints with an axis that are in the URDF, in its order, with positions,
/// velocities and efforts (`jointEffort`). For the simulation's thread.
class JointStates {
 public:
  JointStates(RosNode& ros, const Frames& frames, double rate)
      : ros_(ros), frames_(frames), schedule_(periodOf(rate)) {}

  /// The part of a topic's messages that describes one robot.
  struct RobotJoints {
    const Robot* robot = nullptr;
    /// Prefix for the joints' names.
    std::string prefix = {};
  };
  /// Forgets all topics; call it, followed by `add`, when robots have been added or removed.
  void clear() { topics_.clear(); }
  void add(const std::string& name, const std::vector<RobotJoints>& robots);

  /// @return The absolute names of the topics.
  std::vector<std::string> topics() const;

  void postUpdate(Time now);
  /// Call when time starts again.
  void reset() { schedule_.reset(); }

 private:
  struct JointTopic {
    std::string name;
    std::unique_ptr<RosPublisher> publisher;
    std::vector<std::pair<Joint, int>> axes;
    sensor_msgs::JointState message;
  };
  void publish(JointTopic& topic, const builtin_interfaces::Time& stamp) const;

  RosNode& ros_;
  Frames frames_;
  Schedule schedule_;
  std::list<JointTopic> topics_;
};

}  // namespace pongsim::ros2
