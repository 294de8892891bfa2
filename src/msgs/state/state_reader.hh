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

/// What a state tells of one entity; empty or nothing where it does not.
struct EntityState {
  enum class Kind { kOther, kWorld, kModel, kLink, kJoint, kSensor, kLight };

  std::uint64_t id = 0;
  Kind kind = Kind::kOther;
  std::string name;
  /// Who holds it; 0 for a world.
  std::uint64_t parent = 0;
  /// In the frame of what holds it; of a joint, in that of its child.
  std::optional<Pose> pose;
  bool isStatic = false;
  /// Of a world [m/s^2].
  std::optional<Vector3> gravity;
  /// Of a link.
  std::optional<description::Inertial> inertial;
  /// Of a joint: "revolute".
  std::string jointType;
  /// Of a joint: links as its model sees them, or "world".
  std::string parentLink;
  std::string childLink;
  /// Of a joint: unit vectors in the joint frame.
  std::vector<Vector3> axes;
  /// Of a joint: of each axis [rad or m], [rad/s or m/s].
  std::vector<double> positions;
  std::vector<double> velocities;
  /// Of a sensor whose type has settings in a message.
  std::optional<description::Sensor> sensor;
};

/// @param step An `ignition.msgs.SerializedStepMap`, of whomever. What in it can't be read is left out.
/// @return Its entities in the order of their ids.
std::vector<EntityState> entitiesOf(const Message& step);

}  // namespace pongsim::msgs
