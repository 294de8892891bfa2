#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <memory>

#include "physics/settings.hh"

namespace pongsim::physics {

/// A Bullet world with all that it stands on, set up as `Settings` say.
class DynamicsWorld {
 public:
  explicit DynamicsWorld(const Settings& settings);

  btDiscreteDynamicsWorld& bullet() { return *world_; }

  /// Forgets what touches the body, which is somewhere else now, and finds what it may touch there.
  void moved(btRigidBody& body);

  /// Forgets that the two may touch, and what they touched.
  void separate(btRigidBody& a, btRigidBody& b);

  /// Finds what the body may touch now that the filter says otherwise than before.
  void findPairsOf(btRigidBody& body);

  /// One step of exactly `dt` [s].
  void step(double dt);

 private:
  void forgetRolledContacts(double dt);

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  std::unique_ptr<btConstraintSolver> solver_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
};

}  // namespace pongsim::physics
