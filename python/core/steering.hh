#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/handles.hh"
#include "core/life.hh"

namespace pongsim::python {

/// What becomes of numbers of an action.
struct Steering {
  std::size_t size = 0;
  /// Commands the world. Without the GIL.
  std::function<void(const double*)> apply;
  /// Whether it is to be said again before each physics step, for it holds for one.
  bool isForEachStep = false;
};

/// @return One that publishes a message with these fields.
/// Raises ValueError where the type has no such numbers, or is not known.
Steering messageSteering(const std::shared_ptr<Life>& life, const std::string& topic, const std::string& type,
                         const std::vector<std::string>& paths);
/// @return One that drives the first axis of a joint at a velocity [rad/s or m/s].
Steering velocitySteering(const PyJoint& joint);
/// @return One that applies a force along that axis [N m or N].
Steering forceSteering(const PyJoint& joint);

}  // namespace pongsim::python
