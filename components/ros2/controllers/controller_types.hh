#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "ros2/controllers/controller.hh"

namespace pongsim::ros2 {

/// A class of controllers, by the name that ros2_controllers exports it under.
struct ControllerType {
  /// "diff_drive_controller/DiffDriveController"
  std::string_view name;
  std::unique_ptr<Controller> (*make)();
};

/// @return All known classes, by name.
std::span<const ControllerType> controllerTypes();

/// @return Null for an unknown class.
std::unique_ptr<Controller> makeController(std::string_view type);

}  // namespace pongsim::ros2
