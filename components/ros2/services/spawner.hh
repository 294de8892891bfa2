#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "pongsim/diagnostic.hh"
#include "pongsim/world_edits.hh"
#include "ros2/services/entity_finder.hh"
#include "ros2/services/owed_answers.hh"
#include "ros2/services/result.hh"

namespace pongsim::ros2 {

/// Inserts and removes entities for simulation_interfaces: models are loaded immediately, and added or removed at the
/// end of the step.
class Spawner {
 public:
  using Spawned = std::function<void(const simulation_interfaces::SpawnResult&)>;

  /// All references must outlive it.
  Spawner(const EntityFinder& finder, WorldEdits& edits) : finder_(finder), edits_(edits) {}

  /// @param spawned Called once, possibly before this returns.
  void spawn(const simulation_interfaces::SpawnEntity& request, Spawned spawned);

  /// @param name Of a top-level model.
  /// @param done Called once, possibly before this returns.
  void remove(const std::string& name, std::function<void(const Result&)> done);
  /// Removes everything added since the start.
  void removeInserted(std::function<void(const Result&)> done);

  /// Call after a reset of the world: pending changes are dropped.
  void forget() { owed_.forget(); }

  /// [bytes]
  static constexpr std::size_t kLongestResource = 32 * 1024 * 1024;

 private:
  std::optional<ModelTemplate> read(const simulation_interfaces::Resource& resource, Result& result) const;
  std::optional<ModelTemplate> readAddress(const std::string& uri, Diagnostics& diagnostics, Result& result) const;
  void insert(const ModelTemplate& model, const InsertOptions& options, Spawned spawned);
  void remove(const Model& model, std::function<void(const Result&)> done);

  const EntityFinder& finder_;
  WorldEdits& edits_;
  OwedAnswers owed_;
};

/// @return What is wrong with the name of an entity, or nothing.
std::optional<std::string> entityNameError(const std::string& name);

/// @param nameSpace "robot1" or "/robot1".
/// @return What is wrong with it as a ROS namespace, or nothing.
std::optional<std::string> nameSpaceError(const std::string& nameSpace);

}  // namespace pongsim::ros2
