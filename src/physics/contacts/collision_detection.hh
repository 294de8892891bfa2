#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <span>

#include "base/arena.hh"
#include "shared/threads/workers.hh"
#include "physics/contacts/broad_phase.hh"
#include "physics/contacts/collision_configuration.hh"
#include "physics/contacts/dispatcher.hh"
#include "physics/contacts/swept_boxes.hh"
#include "physics/islands/rest.hh"

namespace pongsim::physics {

/// Bodies in Bullet's broad and narrow phase, and their contacts.
class CollisionDetection {
 public:
  /// @param configuration Must outlive this, as `arena`, `workers` and `rest` must; may be used again afterwards.
  /// @param maxContacts As in `Settings`.
  CollisionDetection(CollisionConfiguration& configuration, base::Arena& arena, shared::Workers& workers, Rest& rest,
                     long long maxContacts)
      : dispatcher_(configuration, arena, workers, rest, maxContacts), boxes_(broadPhase_, workers) {}

  /// Sets which pairs of bodies may touch; must outlive this.
  void setFilter(btOverlapFilterCallback& filter);

  /// Adds a body, and finds its candidate pairs.
  /// @param number Unique: in a pair, the body with the smaller number comes first, whenever it was added, so that
  /// their contacts have the same bits.
  void add(btRigidBody& body, int number);
  /// Removes bodies with their pairs and contacts, without allocating. All must be gone before this is destroyed.
  void remove(std::span<btRigidBody* const> bodies);

  /// Discards the contacts of a body that was moved, and finds its new candidate pairs.
  void moved(btRigidBody& body);
  /// Discards the candidate pair and contacts of two bodies.
  void separate(btRigidBody& a, btRigidBody& b);
  /// Finds the candidate pairs of a body after its filter has changed.
  void findPairsOf(btRigidBody& body);
  /// Finds the contacts of all bodies at their current poses.
  /// @param moving All that forces move.
  void findTouches(std::span<btRigidBody* const> moving, const btDispatcherInfo& info);

  BroadPhase& broadPhase() { return broadPhase_; }
  Dispatcher& dispatcher() { return dispatcher_; }
  SweptBoxes& boxes() { return boxes_; }

 private:
  Dispatcher dispatcher_;
  BroadPhase broadPhase_;
  SweptBoxes boxes_;
};

}  // namespace pongsim::physics
