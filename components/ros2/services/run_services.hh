#pragma once

#include <functional>

#include "pongsim/handles.hh"
#include "pongsim/system.hh"
#include "ros2/services/offers.hh"
#include "ros2/services/run_requests.hh"
#include "ros2/services/service_names.hh"
#include "ros2/services/spawner.hh"

namespace pongsim::ros2 {

/// The services of simulation_interfaces for the simulation itself: its features, state, steps, reset, world.
class RunServices {
 public:
  /// @param spawner Removes what was spawned. All references must outlive it.
  /// @param isStepped Returns whether a paused run is executing the steps of an action's goal.
  RunServices(RosNode& node, const SystemContext& context, const ServiceNames& names, Spawner& spawner,
              std::function<bool()> isStepped);

  /// Call first in each step.
  void preUpdate(const StepInfo& info) { run_.preUpdate(info); }
  /// Call after a reset of the world.
  void worldReset() { run_.worldReset(); }

 private:
  simulation_interfaces::SimulatorFeatures features();
  simulation_interfaces::WorldResource world() const;
  void reset(std::uint8_t scope, const RunRequests::Done& done);

  World world_;
  Spawner& spawner_;
  RunRequests run_;
  std::function<bool()> isStepped_;
  Offers offers_;
};

}  // namespace pongsim::ros2
