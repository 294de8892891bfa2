#pragma once

#include <string>
#include <string_view>

#include "pongsim/node.hh"
#include "ros2/bridge/bridge.hh"

namespace pongsim::ros2 {

/// @return The name of the service that tells what is bridged: "/world/pong/ros2/topics".
std::string topicsServiceOf(std::string_view world);

/// Tells who asks what is bridged: ignition.msgs.Empty is answered with an ignition.msgs.Param_V, of which each Param
/// is a topic with
/// - texts `ros`, `ros_type`, `ignition`, `ignition_type`;
/// - booleans `to_ros`, `from_ros`;
/// - numbers (doubles) `readers` and `writers`, those in ROS that it is matched with; `sent` to and `received` from ROS
///   so far; `dropped`, what some reader did not get; `refused`, what came and was no such message.
class TopicsService {
 public:
  /// @param bridge Must outlive this.
  /// @throws std::invalid_argument where the name is taken.
  TopicsService(Node& simulation, std::string_view world, const Bridge& bridge);

 private:
  Service service_;
};

}  // namespace pongsim::ros2
