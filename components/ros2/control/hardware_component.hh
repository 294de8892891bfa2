#pragma once

#include <string>
#include <vector>

#include "pongsim/element.hh"

namespace pongsim::ros2 {

/// A `<ros2_control>` as the controller manager lists it: a piece of hardware with its interfaces.
struct HardwareComponent {
  /// A `<joint>` or `<sensor>`, and the names of its interfaces: "velocity".
  struct Part {
    std::string name;
    std::vector<std::string> commands;
    std::vector<std::string> states;
  };

  std::string name;
  /// "system", "actuator" or "sensor".
  std::string type;
  /// "gz_ros2_control/GazeboSimSystem"
  std::string plugin;
  std::vector<Part> joints;
  std::vector<Part> sensors;
};

/// @param holder A `<robot>`, or another parent of `<ros2_control>`s.
std::vector<HardwareComponent> hardwareComponents(const Element& holder);

}  // namespace pongsim::ros2
