#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/arena.hh"
#include "physics/body.hh"
#include "physics/contacts/contact_filter.hh"
#include "physics/contacts/friction_frames.hh"
#include "physics/contacts/manifold_state.hh"
#include "physics/engine.hh"
#include "physics/joint.hh"
#include "physics/stepper.hh"

namespace pongsim::physics {

/// What the engine consists of: the bodies and joints of the world by slot, and what finds and solves their contacts.
struct Engine::Parts {
  Parts(const world::Entities& entitiesOfWorld, const Settings& settingsOfWorld, HullStore& hullsOfWorld,
        CollisionConfiguration& configuration, base::Arena& arenaOfWorld)
      : entities(entitiesOfWorld),
        settings(settingsOfWorld),
        hulls(hullsOfWorld),
        arena(arenaOfWorld),
        gravity(entities.description().gravity),
        filter(entities),
        stepper(settings, configuration, arena) {
    stepper.collisions().setFilter(filter);
    grow();
  }
  ~Parts();

  void grow();
  void prepareHulls();
  void addJoints();
  /// Makes room for what `remove` gathers, which must not allocate.
  void makeRoom();
  /// Removes the bodies and joints from these slots on, of which some may be known only in part. Does not allocate.
  void shorten(world::Slot links, world::Slot joints, std::size_t movingLinks) noexcept;
  void remove(const world::Removal& removal);
  void setAside(const world::Entities::Switched& switched);
  void transferKeptTouches(StateArchive& archive);
  /// Removes the bodies of these links from collision detection.
  void takeOut(std::span<const world::Slot> links);
  /// Sets the slots of bodies and joints, and the lists of those that move.
  void renumber();
  /// As `renumber`, where nothing before these has changed.
  void renumberFrom(world::Slot firstLink, world::Slot firstJoint);
  void take(Body& body);
  JointEnd end(world::Slot link, const Pose& X_LinkJoint);
  bool hasAxis(world::Slot joint, std::size_t axis) const {
    return joint < joints.size() && axis < joints[joint]->axisCount();
  }
  Joint& jointWithAxis(world::Slot slot, std::size_t axis);
  Body& bodyOf(const btCollisionObject& object) { return *bodies[static_cast<world::Slot>(object.getUserIndex())]; }
  [[noreturn]] void reportExplosion(world::Slot link) const;

  const world::Entities& entities;
  const Settings settings;
  HullStore& hulls;
  base::Arena& arena;
  SharedShapes shared;
  Vector3 gravity;
  ContactFilter filter;
  Stepper stepper;
  /// What joints to the world hold on to.
  btRigidBody anchor{btRigidBody::btRigidBodyConstructionInfo(0, nullptr, nullptr)};
  /// One a link, in the order of their slots.
  std::vector<base::Arena::Pointer<Body>> bodies;
  std::vector<Body*> moving;
  /// One a joint, in the order of their slots.
  std::vector<base::Arena::Pointer<Joint>> joints;
  /// For each joint, the number of joints between moving bodies up to it.
  std::vector<std::size_t> holdingEnd;
  FrictionFrames frictionFrames;
  /// The contacts of two links of which one, or both, are set aside.
  struct KeptTouch {
    LinkId linkA;
    LinkId linkB;
    ManifoldPoints points;
  };
  std::vector<KeptTouch> keptTouches;
  /// Room for what is gathered while bodies go.
  struct Scratch {
    std::vector<btRigidBody*> freed;
    std::vector<btRigidBody*> bodies;
    std::vector<Joint*> joints;
    std::vector<base::Arena::Pointer<Body>> gone;
  };
  Scratch scratch;
  /// Length of the last step [s].
  double dt = 1;
};

}  // namespace pongsim::physics
