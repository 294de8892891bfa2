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

/// @return A robot in URDF: its own text, where it came as that, else one that is written of it.
/// @param warnings What of it URDF can't say.
std::string descriptionOf(const World& world, const Robot& robot, std::vector<std::string>& warnings);

/// Tells on topics how robots are made, as std_msgs/String that late readers get too. A text is made when the first
/// reader is there. For the simulation's thread.
class RobotDescriptions {
 public:
  RobotDescriptions(const World& world, RosNode& ros) : world_(world), ros_(ros) {}

  /// Says which topics there are now; those that stay keep their readers.
  struct Topic {
    std::string name;
    const Robot* robot = nullptr;
  };
  void follow(const std::vector<Topic>& topics);
  /// In each step: tells who has come.
  void preUpdate();

 private:
  struct Told {
    Topic topic;
    /// The robot of which was told, for its place may become another's.
    ModelId model;
    bool isTold = false;
    std::unique_ptr<RosPublisher> publisher;
  };

  World world_;
  RosNode& ros_;
  std::atomic<std::uint64_t> readersVersion_ = 1;
  std::uint64_t knownReaders_ = 0;
  std::list<Told> told_;
};

}  // namespace pongsim::ros2
