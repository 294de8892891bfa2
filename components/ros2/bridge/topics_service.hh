#pragma once

#include <string>
#include <string_view>

#include "pongsim/node.hh"
#include "ros2/bridge/bridge.hh"

namespace pongsim::ros2 {

/// @return The name of the service that lists bridged topics: "/world/pong/ros2/topics".
std::string topicsServiceOf(std::string_view world);

/// Lists bridged topics on request: answers an ignition.msgs.Empty with an ignition.msgs.Param_V, in which each Param
/// is a topic with
/// - strings `ros`, `ros_type`, `ignition`, `ignition_type`;
/// - booleans `to_ros`, `from_ros`;
/// - numbers (doubles) `readers` and `writers`, the matched ones in ROS; `sent` to and `received` from ROS so far;
/// `dropped`, what some reader did not receive; `refused`, what arrived and was not valid.
class TopicsService {
 public:
  /// @param bridge Must outlive this.
  /// @throws std::invalid_argument if the name is taken.
  TopicsService(Node& simulation, std::string_view world, const Bridge& bridge);

 private:
  Service service_;
};

}  // namespace pongsim::ros2
