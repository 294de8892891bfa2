#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "pongsim/handles.hh"
#include "ros2/services/result.hh"

namespace pongsim::ros2 {

/// Information about entities beside their state: category, description and tags.
class EntityInfos {
 public:
  /// @return What was set, else the model's `<gz:semantics>`. The default category is static object for static models,
  /// robot for models with a movable joint or a sensor, and object for all others, without a description or tags.
  simulation_interfaces::EntityInfo of(const World& world, const Model& model) const;

  /// @return Why it is refused (an unknown category), or success. The information stays until the model is removed or
  /// the world is reset.
  Result set(const Model& model, const simulation_interfaces::EntityInfo& info);

  /// Deletes information about removed models.
  void sweep(const World& world);
  /// Call after a reset of the world.
  void forget() { set_.clear(); }

 private:
  std::unordered_map<std::uint64_t, simulation_interfaces::EntityInfo> set_;
};

/// @return Whether `tags` match a filter; all do if it names none.
bool matches(const simulation_interfaces::TagsFilter& filter, const std::vector<std::string>& tags);

/// @return What is wrong with a filter, or nothing.
std::optional<std::string> filterError(const simulation_interfaces::TagsFilter& filter);

}  // namespace pongsim::ros2
