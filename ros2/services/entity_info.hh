#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "pongsim/handles.hh"
#include "ros2/services/result.hh"

namespace pongsim::ros2 {

/// What is said of entities beside their state: category, description and tags.
class EntityInfos {
 public:
  /// @return What was set. Before that: a static model is a static object, one with a joint that moves or with a sensor
  /// a robot, all others are objects, without a description or tags.
  simulation_interfaces::EntityInfo of(const Model& model) const;

  /// @return Why not (an unknown category), or that it is set. It stays until the model goes or the world is reset.
  Result set(const Model& model, const simulation_interfaces::EntityInfo& info);

  /// Lets go of what is said of models that are not there any more.
  void sweep(const World& world);
  /// The world was reset.
  void forget() { set_.clear(); }

 private:
  std::unordered_map<std::uint64_t, simulation_interfaces::EntityInfo> set_;
};

/// @return Whether `tags` are such as a filter wants; all are where it names none.
bool matches(const simulation_interfaces::TagsFilter& filter, const std::vector<std::string>& tags);

/// @return What is wrong with a filter, or nothing.
std::optional<std::string> filterError(const simulation_interfaces::TagsFilter& filter);

}  // namespace pongsim::ros2
