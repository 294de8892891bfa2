#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/geometry/geodesy.hh"
#include "pongsim/message.hh"
#include "pongsim/types.hh"
#include "pongsim/visual_colors.hh"

namespace pongsim::msgs {

/// A place given by an `ignition.msgs.SphericalCoordinates`.
struct PlaceOnEarth {
  GeodeticPosition position;
  /// Rotation about z, counter-clockwise [rad].
  double heading = 0;
};

/// The request in an `ignition.msgs.EntityFactory`.
struct EntityFactory {
  /// SDF or URDF text; empty: none.
  std::string text;
  std::string file;
  /// Name of a top-level model to copy; empty: none.
  std::string original;
  /// An `ignition.msgs.Light` to add, or null. It is part of the message that this was read from.
  const Message* light = nullptr;
  std::string name;
  /// World frame.
  std::optional<Pose> pose;
  std::optional<PlaceOnEarth> place;
  bool allowRenaming = false;
  /// Name of a field that is set but not supported; empty: none.
  std::string unknownField;
};

/// An entity named by an `ignition.msgs.Entity`.
struct EntityName {
  /// 0: identified by its name.
  std::uint64_t id = 0;
  std::string name;
  /// The type's name in the message's enumeration: "MODEL".
  std::string type;
};

/// An entity and its new pose, from an `ignition.msgs.Pose`.
struct PoseOfEntity {
  EntityName entity;
  /// World frame; has no rotation if the message has none.
  Pose pose;
};

/// An entity and its new place on earth, from an `ignition.msgs.SphericalCoordinates`.
struct PlaceOfEntity {
  /// Nothing: the world's origin.
  std::optional<EntityName> entity;
  PlaceOnEarth place;
};

/// The request in an `ignition.msgs.WheelSlipParametersCmd`.
struct WheelSlip {
  /// A link, or a model for all its links.
  EntityName entity;
  double lateral = 0;
  double longitudinal = 0;
};

/// The request in an `ignition.msgs.Physics`.
struct PhysicsSettings {
  /// [s]; 0: unchanged.
  double stepSize = 0;
  /// Simulated seconds per second of wall time; 0: unchanged.
  double realTimeFactor = 0;
  /// World frame [m/s^2].
  std::optional<Vector3> gravity;
};

/// The request in an `ignition.msgs.Visual`.
struct VisualLook {
  /// 0: identified by its name and its link.
  std::uint64_t id = 0;
  std::string name;
  std::string link;
  std::uint64_t linkId = 0;
  VisualColors colors;
};

/// The request in an `ignition.msgs.Link`.
struct LinkMass {
  EntityName entity;
  /// [kg]
  std::optional<double> mass;
};

/// The request in an `ignition.msgs.Joint`.
struct JointPositions {
  EntityName entity;
  /// Of the first and the second axis [rad or m].
  std::array<std::optional<double>, 2> positions;
};

/// Each function reads a message of the type documented above.
EntityFactory entityFactory(const Message& message);
EntityName entityName(const Message& message);
PoseOfEntity poseOfEntity(const Message& message);
PlaceOfEntity placeOfEntity(const Message& message);
PhysicsSettings physicsSettings(const Message& message);
WheelSlip wheelSlip(const Message& message);
VisualLook visualLook(const Message& message);
LinkMass linkMass(const Message& message);
JointPositions jointPositions(const Message& message);

/// Fills in an `ignition.msgs.WheelSlipParametersCmd`.
void setWheelSlip(const WheelSlip& slip, Message& message);

/// For `ignition.msgs.EntityFactory_V` and `ignition.msgs.Pose_V`.
std::vector<EntityFactory> entityFactories(const Message& message);
std::vector<PoseOfEntity> posesOfEntities(const Message& message);

}  // namespace pongsim::msgs
