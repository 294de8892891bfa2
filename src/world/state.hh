#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "pongsim/geometry/geodesy.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "world/entities.hh"

namespace pongsim::world {

struct LinkState {
  Pose X_WorldLink;
  /// Velocity of the link frame's origin, world frame [m/s].
  Vector3 v_WorldLink = Vector3::Zero();
  /// Angular velocity, world frame [rad/s].
  Vector3 w_WorldLink = Vector3::Zero();
};

/// Positions and velocities of a joint's axes; zero for axes that it does not have.
struct JointState {
  /// Angle since the start, not wrapped [rad], or distance [m].
  double position = 0;
  /// [rad/s] or [m/s]
  double velocity = 0;
  /// Of the second axis.
  double position2 = 0;
  double velocity2 = 0;
};

/// The world's place on the earth.
struct Place {
  bool isKnown = false;
  /// Of the world's origin.
  GeodeticPosition origin;
  /// Of the x axis, anticlockwise from east [rad].
  double heading = 0;
};

/// A battery of a model, and its loads.
struct BatteryState {
  struct Load {
    std::string consumer;
    /// [W]
    double power = 0;
  };
  BatteryId id;
  ModelId model;
  std::string name;
  /// State of charge, 1: full.
  double charge = 1;
  std::vector<Load> loads;
};

/// An actor that is moved by a system instead of its script.
struct ActorState {
  const description::Actor* description = nullptr;
  Pose X_WorldActor;
  /// Name of the limbs' animation, and the time in it.
  std::string animation;
  Time animationTime{0};
};

/// The current state of everything. The arrays correspond to those of `Entities`.
struct State {
  /// The state at the start.
  explicit State(const Entities& entities);

  /// Adds the state of new `entities`, as at their start.
  void grow(const Entities& entities);
  /// Corresponds to `Entities::undoInsertions`.
  void undoInsertions(const Entities& entities) noexcept;
  void remove(const Removal& removal);

  Time time{0};
  std::uint64_t iterations = 0;
  /// World frame [m/s^2]. This and the next four are as in the description until changed.
  Vector3 gravity;
  Time stepSize;
  /// Desired simulated seconds per second; 0: as fast as possible.
  double realTimeFactor;
  Place place;
  /// Wind velocity, world frame [m/s].
  Vector3 wind;
  std::vector<LinkState> links;
  std::vector<JointState> joints;
  /// Commands to the actuators of models, by number.
  std::map<ModelId, std::vector<double>> actuators = {};
  /// The next two are not part of saved states: the systems that set them must remember them.
  std::vector<BatteryState> batteries;
  std::vector<ActorState> actors;
};

/// The whole state, with arrays of the right size.
void transfer(StateArchive& archive, State& state);

/// @return Whether the model has batteries and all are empty.
bool isOutOfPower(const State& state, ModelId model);

/// @return Pose of the model frame in the world frame; it moves with the canonical link.
Pose modelPose(const Entities& entities, const State& state, Slot model);

/// @return Pose of the model frame in the frame of its parent: a model, or the world.
Pose poseInParent(const Entities& entities, const State& state, Slot model);

/// @return Pose of the link frame in the frame of its model.
Pose poseInModel(const Entities& entities, const State& state, Slot link);

/// @return A hash of all bits of the state, by FNV-1a (64 bits) over 64-bit words, each from its lowest byte up: time
/// [ns], iterations, number of links, then for each link position (x, y, z), rotation (w, x, y, z), linear and angular
/// velocity, then the number of joints, and for each joint position and velocity of its first and second axis;
/// floating-point values as the bits of their IEEE 754 doubles. What is set aside counts like all else.
std::uint64_t stateHash(const State& state);

}  // namespace pongsim::world
