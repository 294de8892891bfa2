#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ros2/node/node.hh"
#include "ros2/types/tf2_msgs.hh"

namespace pongsim::ros2 {

/// Watches other nodes for what the simulation publishes, too: a frame that they give a second parent, and joint
/// states. Each is warned about once, with the option that leaves ours out. For the simulation's thread.
class RivalPublishers {
 public:
  explicit RivalPublishers(RosNode& ros) : ros_(ros) {}

  /// Listens to the frames of others.
  void watchTransforms();

  /// @param children Frames that have a parent here.
  void checkTransforms(const std::set<std::string>& children);

  /// @param topic Absolute name of a topic that is published here.
  /// @param option The option of `pongsim run` that leaves it out.
  /// @param meaning What follows: "joints have two sources".
  void checkTopic(const std::string& topic, const std::string& option, const std::string& meaning);

 private:
  void receive(const tf2_msgs::TFMessage& message);

  RosNode& ros_;
  std::mutex mutex_;
  /// Frames of others that are not yet checked, each with its parent.
  std::vector<std::pair<std::string, std::string>> heard_;
  std::set<std::string> known_;
  std::set<std::string> warned_;
  std::unique_ptr<RosSubscription> moving_;
  std::unique_ptr<RosSubscription> static_;
};

}  // namespace pongsim::ros2
