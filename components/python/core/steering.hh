#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/handles.hh"
#include "core/life.hh"
#include "core/memory.hh"

namespace pongsim::python {

/// How numbers of an action are applied.
struct Steering {
  std::size_t size = 0;
  /// Commands the world. Called without the GIL.
  std::function<void(const double*)> apply;
  /// Whether to repeat it before each physics step, because its effect lasts for one.
  bool isForEachStep = false;
};

/// @return A steering that publishes a message with these fields.
/// Raises ValueError if the type is unknown or has no such numeric fields.
Steering messageSteering(const std::shared_ptr<Life>& life, const std::string& topic, const std::string& type,
                         const std::vector<std::string>& paths);
/// @return A steering that drives the first axis of a joint at a velocity [rad/s or m/s].
Steering velocitySteering(PyJoint& joint);
/// @return A steering that moves the axis to a position [rad or m] by the force stiffness (position - present) -
/// damping velocity, computed before each physics step.
/// @param gains Stiffness and damping, two doubles that may change.
Steering positionSteering(PyJoint& joint, std::shared_ptr<Memory> gains);
/// @return A steering that applies a force along that axis [N m or N].
Steering forceSteering(PyJoint& joint);

}  // namespace pongsim::python
