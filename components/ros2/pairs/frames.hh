#pragma once

#include <array>
#include <string>
#include <string_view>

namespace pongsim::ros2 {

/// Variances of a sensor's noise along x, y and z, in its units; zero: none.
struct Variances {
  /// Of angular velocities, magnetic fields, positions (longitude, latitude, altitude), and of a pressure, which is the
  /// first.
  std::array<double, 3> reading{};
  /// Of linear accelerations.
  std::array<double, 3> acceleration{};
  bool operator==(const Variances&) const = default;
};

/// Options for converting names and times, and what messages to ROS have beside those of the simulation.
struct Frames {
  /// Prefix of each frame in ROS: "robot1/".
  std::string prefix = {};
  /// The frame of all messages with a header, used unchanged; empty: each keeps its own.
  std::string frameId = {};
  /// Whether messages to ROS are stamped with wall time instead of simulated time.
  bool usesWallTime = false;
  /// For the covariances in messages to ROS.
  Variances variances = {};
  bool operator==(const Frames&) const = default;

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
