#pragma once

#include <atomic>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/handles.hh"
#include "ros2/node/node.hh"
#include "ros2/robot/robot_list.hh"

namespace pongsim::ros2 {

/// @return The URDF of a robot: its own text if it was loaded from URDF, else one generated from the model.
/// @param warnings Properties that URDF can't express.
std::string descriptionOf(const World& world, const Robot& robot, std::vector<std::string>& warnings);

/// Publishes robot descriptions on topics, as std_msgs/String that late subscribers receive too. A text is generated
/// for its first subscriber. For the simulation's thread.
class RobotDescriptions {
 public:
  RobotDescriptions(const World& world, RosNode& ros) : world_(world), ros_(ros) {}

  /// Sets the current topics; existing ones keep their subscribers.
  struct Topic {
    std::string name;
    const Robot* robot = nullptr;
  };
  void follow(const std::vector<Topic>& topics);
  /// Call in each step: sends the descriptions to new subscribers.
  void preUpdate();

 private:
  struct Description {
    Topic topic;
    /// The model that was published: `topic.robot` may point to another robot at the same address.
    ModelId model;
    bool isPublished = false;
    std::unique_ptr<RosPublisher> publisher;
  };

  World world_;
  RosNode& ros_;
  std::atomic<std::uint64_t> readersVersion_ = 1;
  std::uint64_t knownReaders_ = 0;
  std::list<Description> descriptions_;
};

}  // namespace pongsim::ros2
