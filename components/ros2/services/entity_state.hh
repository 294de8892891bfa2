#pragma once

#include <cstdint>
#include <unordered_map>

#include "pongsim/system.hh"
#include "ros2/services/entity_finder.hh"
#include "ros2/services/result.hh"
#include "ros2/types/simulation_entity_services.hh"

namespace pongsim::ros2 {

/// Accelerations of models: the change of their velocities in the last step. A model's acceleration is measured from
/// the first request on, so that it costs nothing otherwise; the first answer is zero.
class Accelerations {
 public:
  /// World frame [m/s^2, rad/s^2].
  struct Acceleration {
    Vector3 linear = Vector3::Zero();
    Vector3 angular = Vector3::Zero();
  };

  Acceleration of(const Model& model);

  /// Call after each step.
  void stepped(const World& world, const StepInfo& info);
  /// Call after a reset of the world.
  void forget() { known_.clear(); }

 private:
  struct Known {
    MovingFrame last;
    Acceleration acceleration;
  };
  std::unordered_map<std::uint64_t, Known> known_;
};

/// @return Pose, velocities and acceleration in the world frame.
simulation_interfaces::EntityState stateOf(const Model& model, Time now, Accelerations& accelerations);

/// Applies the requested state, which can be given in any frame: velocities are then relative to that frame, along its
/// axes. All or nothing.
Result setState(const EntityFinder& finder, const simulation_interfaces::srv::SetEntityState::Request& request);

}  // namespace pongsim::ros2
