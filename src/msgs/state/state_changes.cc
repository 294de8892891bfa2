#include "pongsim/state/state_changes.hh"

#include <ignition/msgs/double_v.pb.h>
#include <ignition/msgs/serialized_map.pb.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>

#include "msgs/state/component.hh"

namespace pongsim {

namespace {

namespace im = ignition::msgs;

/// Resolution: a micrometre or a microradian.
constexpr double kDigits = 1e6;
// a double has no such digits beyond this
constexpr double kLargestRounded = 1e9;

/// Appends a number rounded to six decimals, without trailing zeros.
void append(double value, std::string& text) {
  char digits[32];
  // the shortest text of the rounded number has exactly these digits; turns -0 into 0
  const double rounded = std::abs(value) < kLargestRounded ? std::round(value * kDigits) / kDigits + 0.0 : value;
  char* const end = std::to_chars(digits, digits + sizeof digits, rounded).ptr;
  if (!text.empty()) text += ' ';
  text.append(digits, end);
}

/// Formats a pose as Fortress's logs do.
void setText(const Pose& pose, std::string& text) {
  text.clear();
  for (const double value : pose.position) append(value, text);
  for (const double value : rollPitchYawOf(pose.rotation)) append(value, text);
}

void setComponent(im::SerializedEntityMap& entity, std::uint64_t type, const std::string& bytes) {
  im::SerializedComponent& component = (*entity.mutable_components())[static_cast<std::int64_t>(type)];
  component.set_type(type);
  component.set_component(bytes);
}

im::SerializedEntityMap& entityOf(std::uint64_t id, im::SerializedStateMap& state) {
  im::SerializedEntityMap& entity = (*state.mutable_entities())[id];
  entity.set_id(id);
  return entity;
}

}  // namespace

struct StateChanges::Told {
  struct Where {
    Pose pose;
    std::string text;
  };

  const std::uint64_t poseType = msgs::componentType("Pose");
  const std::uint64_t positionType = msgs::componentType("JointPosition");
  const std::uint64_t velocityType = msgs::componentType("JointVelocity");
  /// Components by entity id, without those that are in every snapshot.
  std::unordered_map<std::uint64_t, std::map<std::uint64_t, std::string>> entities;
  std::unordered_map<std::uint64_t, Where> places;
  std::unordered_map<std::uint64_t, StateSnapshot::Axes> joints;
  std::string text;
  /// The message being written; empty otherwise.
  std::unique_ptr<im::SerializedStateMap> changes;

  /// @return Whether every snapshot has it. Fortress's logs have no velocities.
  bool isMoving(std::uint64_t entity, std::uint64_t type) const {
    return type == positionType || type == velocityType || (type == poseType && places.contains(entity));
  }

  void tellWhoCameAndWent(const StateSnapshot& snapshot, im::SerializedStateMap& message) {
    const auto& all = static_cast<const im::SerializedStepMap&>(*snapshot.everything).state().entities();
    for (auto known = entities.begin(); known != entities.end();) {
      if (all.count(known->first) > 0) {
        ++known;
        continue;
      }
      entityOf(known->first, message).set_remove(true);
      places.erase(known->first);
      joints.erase(known->first);
      known = entities.erase(known);
    }
    for (const StateSnapshot::Place& place : snapshot.places) places.try_emplace(place.entity);
    for (const auto& [id, entity] : all) {
      for (const auto& [key, component] : entity.components()) {
        if (isMoving(id, component.type())) continue;
        const auto [known, isNew] = entities[id].try_emplace(component.type(), component.component());
        if (!isNew && known->second == component.component()) continue;
        known->second = component.component();
        setComponent(entityOf(id, message), component.type(), known->second);
      }
    }
  }

  void tellPlace(const StateSnapshot::Place& place, im::SerializedStateMap& message) {
    Where& told = places[place.entity];
    if (!told.text.empty() && told.pose == place.X_ParentEntity) return;
    told.pose = place.X_ParentEntity;
    setText(place.X_ParentEntity, text);
    if (text == told.text) return;
    std::swap(text, told.text);
    setComponent(entityOf(place.entity, message), poseType, told.text);
  }

  void tellAxes(const StateSnapshot::Axes& axes, im::SerializedStateMap& message) {
    const auto [known, isNew] = joints.try_emplace(axes.joint, axes);
    if (!isNew && known->second.positions == axes.positions) return;
    known->second = axes;
    im::Double_V positions;
    for (int axis = 0; axis < axes.count; ++axis) positions.add_data(axes.positions[static_cast<std::size_t>(axis)]);
    setComponent(entityOf(axes.joint, message), positionType, positions.SerializeAsString());
  }
};

StateChanges::StateChanges() : told_(std::make_unique<Told>()) {}
StateChanges::~StateChanges() = default;

bool StateChanges::tell(const StateSnapshot& snapshot, Message& stateMap) {
  auto& message = static_cast<im::SerializedStateMap&>(stateMap);
  message.Clear();
  std::unique_ptr<im::SerializedStateMap>& changes = told_->changes;
  if (!changes) changes = std::make_unique<im::SerializedStateMap>();
  try {
    if (snapshot.everything) told_->tellWhoCameAndWent(snapshot, *changes);
    for (const StateSnapshot::Place& place : snapshot.places) told_->tellPlace(place, *changes);
    for (const StateSnapshot::Axes& axes : snapshot.joints) told_->tellAxes(axes, *changes);
  } catch (...) {
    // a protobuf map that could not get memory to grow crashes when it is destroyed or cleared
    static_cast<void>(changes.release());
    throw;
  }
  message.Swap(changes.get());
  return message.entities_size() > 0;
}

}  // namespace pongsim
