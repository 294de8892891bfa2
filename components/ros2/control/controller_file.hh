#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace pongsim::ros2 {

/// Settings for driving joints from the parameter file of a controller manager.
struct ControllerFile {
  /// `update_rate` of controller_manager [Hz].
  std::optional<double> updateRate;
  /// `position_proportional_gain` and `hold_joints` of gz_ros2_control's own node.
  std::optional<double> positionGain;
  std::optional<bool> holdsJoints;
  /// What is wrong with the file; empty: nothing.
  std::string error;
};

/// Reads a ROS parameter file in YAML: nodes, with or without namespaces, each with `ros__parameters`.
ControllerFile readControllerFile(const std::filesystem::path& file);

}  // namespace pongsim::ros2
