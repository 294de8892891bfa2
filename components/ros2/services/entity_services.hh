#pragma once

#include "pongsim/system.hh"
#include "ros2/services/entity_filter.hh"
#include "ros2/services/entity_finder.hh"
#include "ros2/services/entity_info.hh"
#include "ros2/services/entity_state.hh"
#include "ros2/services/offers.hh"
#include "ros2/services/service_names.hh"
#include "ros2/services/spawner.hh"

namespace pongsim::ros2 {

/// The services of simulation_interfaces for entities, named poses and spawnables.
class EntityServices {
 public:
  /// @param node, context Must outlive it.
  EntityServices(RosNode& node, const SystemContext& context, const ServiceNames& names, const Frames& frames);

  /// Call first and last in each step.
  void preUpdate(const StepInfo& info) { now_ = info.time; }
  void postUpdate(const StepInfo& info) { accelerations_.stepped(finder_.world(), info); }
  void worldChanged() { infos_.sweep(finder_.world()); }
  /// Call after a reset of the world.
  void worldReset();

  Spawner& spawner() { return spawner_; }
  const EntityFinder& finder() const { return finder_; }

 private:
  void offerSpawning(const ServiceNames& names);
  void offerEntities(const ServiceNames& names);
  void offerStates(const ServiceNames& names);
  void offerPlaces(const ServiceNames& names);
  void spawnAll(const simulation_interfaces::srv::SpawnEntities::Request& request,
                const Responder<simulation_interfaces::srv::SpawnEntities>& responder);
  std::optional<std::vector<Model>> filtered(const simulation_interfaces::EntityFilters& filters, Result& result) const;

  WorldEdits& edits_;
  EntityFinder finder_;
  EntityInfos infos_;
  Accelerations accelerations_;
  Spawner spawner_;
  Time now_{0};
  Offers offers_;
};

}  // namespace pongsim::ros2
