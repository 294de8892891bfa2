#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "pongsim/types.hh"

namespace ignition::msgs {
class SerializedComponent;
}

namespace pongsim::log {

/// The state in a log, as far as it has been read. Entities have the recording's ids.
class RecordedState {
 public:
  void clear();

  /// Applies a change, an ignition.msgs.SerializedStateMap or SerializedState in protobuf's binary format.
  /// @return Whether it could be parsed; if not, it is ignored.
  bool apply(std::string_view type, std::string_view payload);

  /// @return Whether entities have been added or removed since the last call.
  bool takeNews();
  /// @return Entities that have changed since the last call.
  std::unordered_set<std::uint64_t> takeChanged();

  /// @return The ids of the entities with this component, in ascending order.
  std::vector<std::uint64_t> entitiesWith(std::string_view component) const;
  /// @return The children of an entity with this component.
  std::vector<std::uint64_t> childrenWith(std::uint64_t parent, std::string_view component) const;

  /// @return A component's bytes; null if the entity does not have it.
  const std::string* find(std::uint64_t entity, std::string_view component) const;
  /// @return The component as text; empty if the entity does not have it.
  std::string text(std::uint64_t entity, std::string_view component) const;
  std::uint64_t parentOf(std::uint64_t entity) const;
  /// @return The pose in the parent's frame; the identity if none is recorded.
  Pose poseOf(std::uint64_t entity) const;
  /// @return Numbers of an ignition.msgs.Double_V.
  std::vector<double> numbersOf(std::uint64_t entity, std::string_view component) const;
  /// @return Its name with those of the enclosing models: "outer::inner".
  std::string scopedName(std::uint64_t entity) const;

 private:
  using Components = std::map<std::uint64_t, std::string>;
  void remove(std::uint64_t entity);
  void set(std::uint64_t entity, const ignition::msgs::SerializedComponent& component);

  std::unordered_map<std::uint64_t, Components> entities_;
  std::unordered_set<std::uint64_t> changed_;
  bool hasNews_ = false;
};

}  // namespace pongsim::log
