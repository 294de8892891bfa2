#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/threads/workers.hh"
#include "physics/contacts/broad_phase.hh"

namespace pongsim::physics {

/// The swept bounding box of each body that forces move: it holds the body where it is and where it gets in the coming
/// step. It is computed when the last step has moved the body, and again if the body was moved or given a velocity
/// since.
class SweptBoxes {
 public:
  SweptBoxes(BroadPhase& broadPhase, shared::Workers& workers) : broadPhase_(broadPhase), workers_(workers) {}

  /// Sets the number of bodies, of which the first `kept` are the same as before.
  void resize(std::size_t kept, std::size_t bodies);

  /// Computes a body's box. May be called for several bodies at once.
  /// @param dt Length of the coming step [s].
  void sweep(btRigidBody& body, std::size_t number, double dt);
  /// To be called when a body was moved or given a velocity.
  void forget(std::size_t number);

  /// Computes boxes that are not known, and gives bodies that have left their fat boxes new ones.
  /// @param bodies All that forces move, in the order of their numbers.
  void update(std::span<btRigidBody* const> bodies, double dt);
  /// Likewise for bodies at their current poses, without motion. Forgets the boxes then.
  void updateInPlace(std::span<btRigidBody* const> bodies);
  /// Gives a body that was moved, which may be static, a fat box without margin.
  void updateInPlace(btRigidBody& body);

 private:
  /// Whether a body is still within its fat box.
  enum class Within : std::uint8_t { kYes, kNo, kTooFast, kUnknown };

  static Within withinFatBox(btRigidBody& body, const btTransform& then);
  template <class Work>
  void forEach(std::span<btRigidBody* const> bodies, Work&& work);
  void fattenBoxes(std::span<btRigidBody* const> bodies);

  BroadPhase& broadPhase_;
  shared::Workers& workers_;
  std::vector<Within> within_;
  bool isOneUnknown_ = false;
  /// Length of the step that the boxes are for [s].
  double dt_ = 0;
};

}  // namespace pongsim::physics
