#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <cstdint>

#include "physics/collision_configuration.hh"
#include "physics/dispatcher.hh"
#include "physics/grouped_world.hh"
#include "physics/settings.hh"
#include "pongsim/state_archive.hh"

namespace pongsim::physics {

/// A Bullet world with all that it stands on, set up as `Settings` say.
class DynamicsWorld {
 public:
  /// @param configuration Must outlive it, and may serve another world after it.
  DynamicsWorld(const Settings& settings, CollisionConfiguration& configuration, GroupWork& work);

  GroupedWorld& bullet() { return world_; }

  /// Takes a body in.
  /// @param number Of its own and larger than those of the bodies before it: of a pair, the one with the smaller number
  /// comes first, whenever it was taken in, so that what is found between the two has the same bits.
  void add(btRigidBody& body, std::uint64_t number);

  /// Finds what bodies touch where they are now, without moving them.
  void findTouches() { world_.performDiscreteCollisionDetection(); }
  Dispatcher& dispatcher() { return dispatcher_; }

  /// Forgets what touches the body, which is somewhere else now, and finds what it may touch there.
  void moved(btRigidBody& body);

  /// Forgets that the two may touch, and what they touched.
  void separate(btRigidBody& a, btRigidBody& b);

  /// Finds what the body may touch now that the filter says otherwise than before.
  void findPairsOf(btRigidBody& body);

  /// Takes the points at which bodies touch, or puts them in place of those that it finds where the bodies are now.
  void transferContacts(StateArchive& archive);

  /// Bodies at rest are no longer, for something that is not theirs has changed.
  void forgetRest();

  /// One step of exactly `dt` [s].
  void step(double dt);

 private:
  void forgetRolledContacts(double dt);

  base::Workers workers_;
  Rest rest_;
  Dispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  GroupedWorld world_;
  /// Length of the last step [s].
  double lastStep_ = 0;
  /// Only a step finds out who rests: without one since `forgetRest` there is nothing to forget.
  bool hasStepped_ = false;
};

}  // namespace pongsim::physics
