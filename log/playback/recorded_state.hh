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

/// The state that a log tells of, as far as it has been read. Entities have the ids of the recording.
class RecordedState {
 public:
  void clear();

  /// Takes what has changed, an ignition.msgs.SerializedStateMap or SerializedState in protobuf's binary form.
  /// @return Whether it could be read; if not, it is left out.
  bool apply(std::string_view type, std::string_view payload);

  /// @return Whether somebody has come or gone since this was asked last.
  bool takeNews();
  /// @return Who has changed since this was asked last.
  std::unordered_set<std::uint64_t> takeChanged();

  /// @return The ids of the entities with that component, in ascending order.
  std::vector<std::uint64_t> entitiesWith(std::string_view component) const;
  /// @return Those with that component that an entity holds.
  std::vector<std::uint64_t> childrenWith(std::uint64_t parent, std::string_view component) const;

  /// @return A component's bytes; null where the entity has it not.
  const std::string* find(std::uint64_t entity, std::string_view component) const;
  /// @return Its text; empty where the entity has it not.
  std::string text(std::uint64_t entity, std::string_view component) const;
  std::uint64_t parentOf(std::uint64_t entity) const;
  /// @return In the frame of what holds it; that frame itself where none is told.
  Pose poseOf(std::uint64_t entity) const;
  /// @return Numbers of an ignition.msgs.Double_V.
  std::vector<double> numbersOf(std::uint64_t entity, std::string_view component) const;
  /// @return Its name with those of the models that hold it: "outer::inner".
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
