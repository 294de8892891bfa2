#pragma once

#include <cstdint>

#include "base/arena.hh"
#include "physics/contacts/broad_phase.hh"
#include "physics/contacts/collision_configuration.hh"
#include "physics/contacts/dispatcher.hh"
#include "physics/settings.hh"
#include "physics/solving/grouped_world.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim::physics {

/// A Bullet world with everything it needs, configured by `Settings`.
class DynamicsWorld {
 public:
  /// @param configuration Must outlive this, as `arena` must; may be used by another world afterwards.
  DynamicsWorld(const Settings& settings, CollisionConfiguration& configuration, base::Arena& arena, GroupWork& work);

  GroupedWorld& bullet() { return world_; }

  /// Adds a body.
  /// @param number Unique and larger than those of earlier bodies: in a pair, the body with the smaller number comes
  /// first regardless of when it was added, so that their contacts have the same bits.
  void add(btRigidBody& body, std::uint64_t number);

  /// Finds the contacts of bodies at their current poses, without moving them.
  void findTouches() { world_.performDiscreteCollisionDetection(); }
  Dispatcher& dispatcher() { return dispatcher_; }

  /// Discards the contacts of a body that was moved, and finds its new candidate pairs.
  void moved(btRigidBody& body);

  /// Discards the candidate pair and contacts of two bodies.
  void separate(btRigidBody& a, btRigidBody& b);

  /// Finds the candidate pairs of a body after its filter has changed.
  void findPairsOf(btRigidBody& body);

  /// Saves the contact points, or replaces those found at the current poses by saved ones.
  void transferContacts(StateArchive& archive);

  /// Wakes resting bodies after an external change.
  void forgetRest();

  /// Makes one step of exactly `dt` [s].
  void step(double dt);

 private:
  shared::Workers workers_;
  Rest rest_;
  Dispatcher dispatcher_;
  BroadPhase broadphase_;
  GroupedWorld world_;
  /// Length of the last step [s].
  double lastStep_ = 0;
  /// Only a step puts bodies to rest: without one since `forgetRest` there are none to wake.
  bool hasStepped_ = false;
};

}  // namespace pongsim::physics
