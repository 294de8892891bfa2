#include "physics/contacts/manifold_state.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

#include "description/limits.hh"
#include "physics/convert.hh"
#include "physics/shapes/shape.hh"

namespace pongsim::physics {

namespace {

/// Identifies a manifold: slots of the links, numbers of their collisions.
using Key = std::array<int, 4>;

Key keyOf(const btPersistentManifold& manifold) {
  return {manifold.getBody0()->getUserIndex(), manifold.m_companionIdA, manifold.getBody1()->getUserIndex(),
          manifold.m_companionIdB};
}

// an impulse beyond has no meaning, whatever the masses [N s]
constexpr double kMostImpulse = 1e30;

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
  // nothing depends on its age in steps
  for (int* value :
       {&point.m_partId0, &point.m_partId1, &point.m_index0, &point.m_index1, &point.m_contactPointFlags}) {
    archive(*value);
  }
  archive.check(std::abs(point.m_normalWorldOnB.length2() - 1) < 1e-6 && point.m_combinedFriction >= 0 &&
                isWithin(point.getPositionWorldOnA(), description::kFarthestSaved) &&
                isWithin(point.getPositionWorldOnB(), description::kFarthestSaved) &&
                std::abs(point.m_appliedImpulse) <= kMostImpulse);
}

/// @return Whether it is the number of a collision of the body.
bool isCollision(int number, const btCollisionObject& object) {
  const auto* shape = static_cast<const LinkShape*>(object.getUserPointer());
  return number >= 0 && shape != nullptr && static_cast<std::size_t>(number) < shape->partCount();
}

}  // namespace

void ManifoldPoints::transfer(StateArchive& archive) {
  std::size_t count = points.size();
  archive(count);
  for (int* value : {&linkA, &partA, &linkB, &partB}) archive(*value);
  archive.check(count <= MANIFOLD_CACHE_SIZE);
  if (archive.isGiving()) points.assign(count, btManifoldPoint());
  for (btManifoldPoint& point : points) transferPoint(archive, point);
}

std::vector<ManifoldPoints> listManifolds(Dispatcher& dispatcher) {
  // sorted by key: the order of creation depends on threads and on the past
  std::map<Key, btPersistentManifold*> manifolds;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
    if (manifold->getNumContacts() != 0) manifolds.emplace(keyOf(*manifold), manifold);
  }
  std::vector<ManifoldPoints> list;
  for (const auto& [key, manifold] : manifolds) {
    ManifoldPoints& entry = list.emplace_back(ManifoldPoints{key[0], key[1], key[2], key[3], {}});
    for (int j = 0; j < manifold->getNumContacts(); ++j) entry.points.push_back(manifold->getContactPoint(j));
  }
  return list;
}

void restoreManifolds(const std::vector<ManifoldPoints>& list, Dispatcher& dispatcher) {
  std::map<Key, btPersistentManifold*> manifolds;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
    manifold->clearManifold();
    manifolds.emplace(keyOf(*manifold), manifold);
  }
  for (const ManifoldPoints& entry : list) {
    const auto found = manifolds.find({entry.linkA, entry.partA, entry.linkB, entry.partB});
    if (found == manifolds.end() || found->second->getNumContacts() != 0) continue;
    // "predictive": skips the check that the point is near enough
    for (const btManifoldPoint& point : entry.points) {
      btPersistentManifold& manifold = *found->second;
      const bool isOfBodies =
          isCollision(point.m_index0, *manifold.getBody0()) && isCollision(point.m_index1, *manifold.getBody1());
      if (isOfBodies) manifold.addManifoldPoint(point, true);
    }
  }
}

void transferManifolds(StateArchive& archive, Dispatcher& dispatcher) {
  std::vector<ManifoldPoints> list;
  if (!archive.isGiving()) list = listManifolds(dispatcher);
  archive(list);
  if (archive.isGiving()) restoreManifolds(list, dispatcher);
}

}  // namespace pongsim::physics
