#include "physics/manifold_state.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <array>
#include <map>

#include "physics/convert.hh"

namespace pongsim::physics {

namespace {

/// Whose points they are: slots of the links, numbers of their collisions.
using Key = std::array<int, 4>;

Key keyOf(const btPersistentManifold& manifold) {
  return {manifold.getBody0()->getUserIndex(), manifold.m_companionIdA, manifold.getBody1()->getUserIndex(),
          manifold.m_companionIdB};
}

void transferPoint(StateArchive& archive, btManifoldPoint& point) {
  for (btVector3* vector :
       {&point.m_localPointA, &point.m_localPointB, &point.m_positionWorldOnA, &point.m_positionWorldOnB,
        &point.m_normalWorldOnB, &point.m_lateralFrictionDir1, &point.m_lateralFrictionDir2}) {
    transferVector(archive, *vector);
  }
  for (double* value :
       {&point.m_distance1, &point.m_combinedFriction, &point.m_combinedRollingFriction,
        &point.m_combinedSpinningFriction, &point.m_combinedRestitution, &point.m_appliedImpulse, &point.m_prevRHS,
        &point.m_appliedImpulseLateral1, &point.m_appliedImpulseLateral2, &point.m_contactMotion1,
        &point.m_contactMotion2, &point.m_contactCFM, &point.m_contactERP, &point.m_frictionCFM}) {
    archive(*value);
  }
  for (int* value : {&point.m_partId0, &point.m_partId1, &point.m_index0, &point.m_index1, &point.m_contactPointFlags,
                     &point.m_lifeTime}) {
    archive(*value);
  }
}

void takeManifolds(StateArchive& archive, Dispatcher& dispatcher) {
  // in the order of their keys: that in which they were made depends on threads and on the past
  std::map<Key, btPersistentManifold*> manifolds;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
    if (manifold->getNumContacts() != 0) manifolds.emplace(keyOf(*manifold), manifold);
  }
  for (const auto& [key, manifold] : manifolds) {
    int count = manifold->getNumContacts();
    archive(count);
    Key copy = key;
    for (int& value : copy) archive(value);
    for (int j = 0; j < count; ++j) transferPoint(archive, manifold->getContactPoint(j));
  }
  int end = 0;
  archive(end);
}

void giveManifolds(StateArchive& archive, Dispatcher& dispatcher) {
  std::map<Key, btPersistentManifold*> manifolds;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
    manifold->clearManifold();
    manifolds.emplace(keyOf(*manifold), manifold);
  }
  int count = 0;
  for (archive(count); count > 0; archive(count)) {
    Key key{};
    for (int& value : key) archive(value);
    const auto found = manifolds.find(key);
    for (int j = 0; j < count; ++j) {
      btManifoldPoint point;
      transferPoint(archive, point);
      // "predictive": it is not looked at whether the point is near enough
      if (found != manifolds.end()) found->second->addManifoldPoint(point, true);
    }
  }
}

}  // namespace

void transferManifolds(StateArchive& archive, Dispatcher& dispatcher) {
  if (archive.isGiving()) {
    giveManifolds(archive, dispatcher);
  } else {
    takeManifolds(archive, dispatcher);
  }
}

}  // namespace pongsim::physics
