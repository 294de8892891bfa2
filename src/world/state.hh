#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "pongsim/geodesy.hh"
#include "pongsim/state_archive.hh"
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

/// Of a joint's axes; zero for those that it has not.
struct JointState {
  /// Angle since the start, not wrapped [rad], or travel [m].
  double position = 0;
  /// [rad/s] or [m/s]
  double velocity = 0;
  /// Of the second axis.
  double position2 = 0;
  double velocity2 = 0;
};

/// Where on the earth the world is.
struct Place {
  bool isKnown = false;
  /// Of the world's origin.
  GeodeticPosition origin;
  /// Of the x axis, anticlockwise from east [rad].
  double heading = 0;
};

/// How a group of entities stands that is set aside.
struct StatePart {
  std::vector<LinkState> links;
  std::vector<JointState> joints;
};

/// A battery of a model, and what drains it.
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

/// An actor that goes as a system says, in place of its script.
struct ActorState {
  const description::Actor* description = nullptr;
  Pose X_WorldActor;
  /// Of its limbs: name and how far on it is.
  std::string animation;
  Time animationTime{0};
};

/// How everything stands now. The arrays go with those of `Entities`.
struct State {
  /// The state at the start.
  explicit State(const Entities& entities);

  /// Gives what has come into `entities` its place, where it is at the start.
  void grow(const Entities& entities);
  void remove(const Removal& removal);
  /// Goes with `Entities::setAside` and `bringBack`.
  std::vector<StatePart> setAside(const GroupSlots& groups);
  void bringBack(const GroupSlots& groups, std::vector<StatePart> parts);

  Time time{0};
  std::uint64_t iterations = 0;
  /// World frame [m/s^2]. This and the next four are what the description says until they are changed.
  Vector3 gravity;
  Time stepSize;
  /// Simulated seconds a second; 0 means as many as possible.
  double realTimeFactor;
  Place place;
  /// Velocity of the air, world frame [m/s].
  Vector3 wind;
  std::vector<LinkState> links;
  std::vector<JointState> joints;
  /// What a system of a model tells the actuators of the model, by their numbers.
  std::map<ModelId, std::vector<double>> actuators = {};
  /// These two are no part of saved states: the systems that say them remember them.
  std::vector<BatteryState> batteries;
  std::vector<ActorState> actors;
};

/// All of a state whose arrays have the right size already.
void transfer(StateArchive& archive, State& state);
void transfer(StateArchive& archive, StatePart& part);

/// @return Whether the model has batteries and all of them are empty.
bool isOutOfPower(const State& state, ModelId model);

/// @return Pose of the model frame in the world frame: the model moves with its canonical link.
Pose modelPose(const Entities& entities, const State& state, Slot model);

/// @return Pose of the model frame in the frame of what holds it: a model, or the world.
Pose poseInParent(const Entities& entities, const State& state, Slot model);

/// @return Pose of the link frame in the frame of its model.
Pose poseInModel(const Entities& entities, const State& state, Slot link);

/// @return A number made of all bits of the state, by FNV-1a (64 bits) over 64-bit words, each taken from its lowest
/// byte up: time [ns], iterations, number of links, then of each link position (x, y, z), rotation (w, x, y, z),
/// linear and angular velocity, then the number of joints and of each position and velocity, of its first axis and of
/// its second; floating-point values as the bits of their IEEE 754 doubles. Then the same of the links and joints of
/// each part that is set aside.
std::uint64_t stateHash(const State& state, const std::vector<const StatePart*>& parts = {});

}  // namespace pongsim::world
