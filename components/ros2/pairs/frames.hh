#pragma once

#include <string>
#include <string_view>

namespace pongsim::ros2 {

/// Options for converting names and times.
struct Frames {
  /// Prefix of each frame in ROS: "robot1/".
  std::string prefix = {};
  /// The frame of all messages with a header, used unchanged; empty: each keeps its own.
  std::string frameId = {};
  /// Whether messages to ROS are stamped with wall time instead of simulated time.
  bool usesWallTime = false;

  /// Converts "vehicle::chassis::lidar" to "vehicle/chassis/lidar", with the prefix in front.
  void toRos(std::string_view frame, std::string& to) const;
  std::string toRos(std::string_view frame) const {
    std::string name;
    toRos(frame, name);
    return name;
  }
  /// @return The frame without the prefix. Slashes stay, because it is unknown which of them were "::".
  std::string_view fromRos(std::string_view frame) const;
};

}  // namespace pongsim::ros2
