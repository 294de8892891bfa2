#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

namespace pongsim::physics {

/// Finds where pairs of bodies touch, and knows of each manifold (the points at which two parts touch) whose it is: the
/// numbers of the two collisions in their links are its companion ids A and B, -1 where a body is made of several parts
/// and all of it is meant. Collisions whose `<collide_bitmask>` share no bit do not touch.
class Dispatcher final : public btCollisionDispatcher {
 public:
  using btCollisionDispatcher::btCollisionDispatcher;

  btCollisionAlgorithm* findAlgorithm(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                      btPersistentManifold* shared, ebtDispatcherQueryType type) override;
  btPersistentManifold* getNewManifold(const btCollisionObject* a, const btCollisionObject* b) override;

 private:
  /// For two parts that do not touch.
  btCollisionAlgorithm* noAlgorithm(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                    btPersistentManifold* shared);

  // an algorithm makes its manifold when it is made itself, or as the first thing that it does then
  const btCollisionObject* lastA_ = nullptr;
  int lastPartA_ = -1;
  int lastPartB_ = -1;
};

}  // namespace pongsim::physics
