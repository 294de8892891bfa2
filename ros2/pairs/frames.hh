#pragma once

#include <string>
#include <string_view>

namespace pongsim::ros2 {

/// What conversion has to know of names and times.
struct Frames {
  /// In front of each frame of ROS: "robot1/".
  std::string prefix = {};
  /// The frame of all messages with a header, as it is; empty: each has its own.
  std::string frameId = {};
  /// Whether messages to ROS are stamped with the time of the wall, in place of the simulation's.
  bool usesWallTime = false;

  /// @return "vehicle::chassis::lidar" as "vehicle/chassis/lidar", with the prefix in front.
  void toRos(std::string_view frame, std::string& to) const;
  std::string toRos(std::string_view frame) const {
    std::string name;
    toRos(frame, name);
    return name;
  }
  /// @return Without the prefix. Slashes stay: nobody can say which of them were "::".
  std::string_view fromRos(std::string_view frame) const;
};

}  // namespace pongsim::ros2
