#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/geometry/geodesy.hh"
#include "pongsim/message.hh"
#include "pongsim/types.hh"

namespace pongsim::msgs {

/// Where something is to be put, as `ignition.msgs.SphericalCoordinates` has it.
struct PlaceOnEarth {
  GeodeticPosition position;
  /// Turned so far about z, anticlockwise [rad].
  double heading = 0;
};

/// What `ignition.msgs.EntityFactory` asks for.
struct EntityFactory {
  /// SDF or URDF text; empty: none.
  std::string text;
  std::string file;
  /// A model of the top level to copy; empty: none.
  std::string original;
  /// An `ignition.msgs.Light` to add, or null. It lives as long as the message that this was read from.
  const Message* light = nullptr;
  std::string name;
  /// World frame.
  std::optional<Pose> pose;
  std::optional<PlaceOnEarth> place;
  bool allowRenaming = false;
  /// A field that is filled in and means nothing here; empty: none.
  std::string unknownField;
};

/// What `ignition.msgs.Entity` names.
struct EntityName {
  /// 0: named by its name.
  std::uint64_t id = 0;
  std::string name;
  /// The type's name in the message's enumeration: "MODEL".
  std::string type;
};

/// Who is to go where, as `ignition.msgs.Pose` has it.
struct PoseOfEntity {
  EntityName entity;
  /// World frame; without a rotation where the message has none.
  Pose pose;
};

/// Who is to be where on the earth, as `ignition.msgs.SphericalCoordinates` has it.
struct PlaceOfEntity {
  /// Nothing: the world's origin.
  std::optional<EntityName> entity;
  PlaceOnEarth place;
};

/// What `ignition.msgs.WheelSlipParametersCmd` asks for.
struct WheelSlip {
  /// A link, or a model with all of its links.
  EntityName entity;
  double lateral = 0;
  double longitudinal = 0;
};

/// What `ignition.msgs.Physics` asks for.
struct PhysicsSettings {
  /// [s]; 0: as it is.
  double stepSize = 0;
  /// Simulated seconds a second; 0: as it is.
  double realTimeFactor = 0;
  /// World frame [m/s^2].
  std::optional<Vector3> gravity;
};

/// Each reads a message of the type that is named above.
EntityFactory entityFactory(const Message& message);
EntityName entityName(const Message& message);
PoseOfEntity poseOfEntity(const Message& message);
PlaceOfEntity placeOfEntity(const Message& message);
PhysicsSettings physicsSettings(const Message& message);
WheelSlip wheelSlip(const Message& message);

/// Fills in an `ignition.msgs.WheelSlipParametersCmd`.
void setWheelSlip(const WheelSlip& slip, Message& message);

/// Of `ignition.msgs.EntityFactory_V` and `ignition.msgs.Pose_V`.
std::vector<EntityFactory> entityFactories(const Message& message);
std::vector<PoseOfEntity> posesOfEntities(const Message& message);

}  // namespace pongsim::msgs
