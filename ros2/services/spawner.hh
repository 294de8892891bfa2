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

/// Inserts and removes entities as simulation_interfaces has it: the models are read at once, and come or go at the
/// end of the step.
class Spawner {
 public:
  using Spawned = std::function<void(const simulation_interfaces::SpawnResult&)>;

  /// All references must outlive it.
  Spawner(const EntityFinder& finder, WorldEdits& edits) : finder_(finder), edits_(edits) {}

  /// @param spawned Called once, maybe at once.
  void spawn(const simulation_interfaces::SpawnEntity& asked, Spawned spawned);

  /// @param name Of a model at the top level.
  /// @param done Called once, maybe at once.
  void remove(const std::string& name, std::function<void(const Result&)> done);
  /// Removes all that came since the start.
  void removeInserted(std::function<void(const Result&)> done);

  /// The world was reset: what was to be done is not.
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

/// @return Why a name can't be that of an entity, or nothing.
std::optional<std::string> entityNameError(const std::string& name);

/// @param nameSpace "robot1" or "/robot1".
/// @return Why it can be no namespace of ROS, or nothing.
std::optional<std::string> nameSpaceError(const std::string& nameSpace);

}  // namespace pongsim::ros2
