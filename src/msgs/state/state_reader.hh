#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "description/link.hh"
#include "description/sensor.hh"
#include "pongsim/message.hh"
#include "pongsim/types.hh"

namespace pongsim::msgs {

/// The data of one entity in a state; fields that the state lacks are empty or nothing.
struct EntityState {
  enum class Kind { kOther, kWorld, kModel, kLink, kJoint, kSensor, kLight };

  std::uint64_t id = 0;
  Kind kind = Kind::kOther;
  std::string name;
  /// Id of the parent; 0 for a world.
  std::uint64_t parent = 0;
  /// In the parent's frame; for a joint, in that of its child.
  std::optional<Pose> pose;
  bool isStatic = false;
  /// Worlds only [m/s^2].
  std::optional<Vector3> gravity;
  /// Links only.
  std::optional<description::Inertial> inertial;
  /// Joints only: "revolute".
  std::string jointType;
  /// Joints only: links as named in the joint's model, or "world".
  std::string parentLink;
  std::string childLink;
  /// Joints only: unit vectors in the joint frame.
  std::vector<Vector3> axes;
  /// Joints only, for each axis [rad or m], [rad/s or m/s].
  std::vector<double> positions;
  std::vector<double> velocities;
  /// Only for sensors whose type has settings in a message.
  std::optional<description::Sensor> sensor;
};

/// @param step An `ignition.msgs.SerializedStepMap` from any source. Unreadable parts are left out.
/// @return Its entities, sorted by id.
std::vector<EntityState> entitiesOf(const Message& step);

}  // namespace pongsim::msgs
