#pragma once

#include <cstdint>
#include <unordered_map>

#include "pongsim/system.hh"
#include "ros2/services/entity_finder.hh"
#include "ros2/services/result.hh"
#include "ros2/types/simulation_entity_services.hh"

namespace pongsim::ros2 {

/// Accelerations of models: by how much their velocities changed in the last step. That of a model is measured from the
/// first time on that somebody asks for it, so that nobody else pays for it; the first answer is zero.
class Accelerations {
 public:
  /// World frame [m/s^2, rad/s^2].
  struct Acceleration {
    Vector3 linear = Vector3::Zero();
    Vector3 angular = Vector3::Zero();
  };

  Acceleration of(const Model& model);

  /// To be called behind each step.
  void stepped(const World& world, const StepInfo& info);
  /// The world was reset.
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

/// Sets what the request says of a state, which may be given in any frame: velocities are then relative to that frame,
/// along its axes. All or nothing.
Result setState(const EntityFinder& finder, const simulation_interfaces::srv::SetEntityState::Request& request);

}  // namespace pongsim::ros2
