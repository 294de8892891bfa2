#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/threads/workers.hh"
#include "physics/contacts/broad_phase.hh"

namespace pongsim::physics {

/// Of each body that forces move, the box that holds it where it is and where it gets in the coming step. It is found
/// when the last step has moved the body, and anew where somebody has changed something since.
class SweptBoxes {
 public:
  SweptBoxes(BroadPhase& broadPhase, shared::Workers& workers) : broadPhase_(broadPhase), workers_(workers) {}

  /// There are so many bodies, of which the first `kept` are those of before.
  void resize(std::size_t kept, std::size_t bodies);

  /// Finds a body's box. May be called for several at once.
  /// @param dt Length of the coming step [s].
  void sweep(btRigidBody& body, std::size_t number, double dt);
  /// Somebody has moved the body or set its velocity.
  void forget(std::size_t number);

  /// Finds boxes that are not known, and puts bodies that have left their boxes in the broad phase into new ones.
  /// @param bodies All that forces move, in the order of their numbers.
  void update(std::span<btRigidBody* const> bodies, double dt, btCollisionWorld& world);
  /// Likewise of bodies where they are now, with no step to come. Forgets the boxes then.
  void updateInPlace(std::span<btRigidBody* const> bodies, btCollisionWorld& world);

 private:
  /// Whether a body's box in the broad phase's tree still holds it.
  enum class Stay : std::uint8_t { kYes, kNo, kAbsurd, kUnknown };

  static Stay stayOf(btRigidBody& body, const btTransform& then);
  template <class Work>
  void forEach(std::span<btRigidBody* const> bodies, Work&& work);
  void putThoseThatLeft(std::span<btRigidBody* const> bodies, btCollisionWorld& world);

  BroadPhase& broadPhase_;
  shared::Workers& workers_;
  std::vector<Stay> stays_;
  bool isOneUnknown_ = false;
  /// Length of the step that the boxes are for [s].
  double dt_ = 0;
};

}  // namespace pongsim::physics
