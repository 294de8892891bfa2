#include "physics/islands/rest.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cassert>
#include <cstring>

namespace pongsim::physics {

namespace {

bool isSame(const btVector3& a, const btVector3& b) { return std::memcmp(&a[0], &b[0], 3 * sizeof(btScalar)) == 0; }

bool isSame(const btTransform& a, const btTransform& b) {
  return isSame(a.getOrigin(), b.getOrigin()) && isSame(a.getBasis()[0], b.getBasis()[0]) &&
         isSame(a.getBasis()[1], b.getBasis()[1]) && isSame(a.getBasis()[2], b.getBasis()[2]);
}

template <class Use>
void forEachImpulse(std::span<btPersistentManifold* const> manifolds, Use&& use) {
  for (const btPersistentManifold* manifold : manifolds) {
    for (int i = 0; i < manifold->getNumContacts(); ++i) {
      const btManifoldPoint& point = manifold->getContactPoint(i);
      for (const double impulse :
           {point.m_appliedImpulse, point.m_appliedImpulseLateral1, point.m_appliedImpulseLateral2}) {
        use(impulse);
      }
    }
  }
}

}  // namespace

void Rest::resize(std::size_t kept, std::size_t bodies) {
  std::size_t first = kept < count_ ? 0 : kept;
  if (bodies > capacity_) {
    capacity_ = std::max(bodies, 2 * capacity_);
    records_ = std::make_unique<Record[]>(capacity_);
    first = 0;
  }
  count_ = bodies;
  for (std::size_t i = first; i < bodies; ++i) {
    records_[i].isStill = false;
    records_[i].island = {};
  }
}

bool Rest::isStill(const btCollisionObject& object) const {
  return object.getIslandTag() < 0 ? object.isStaticObject() : recordOf(object).isStill;
}

void Rest::disturb(const btCollisionObject& object) {
  if (object.getIslandTag() >= 0) recordOf(object).isDisturbed.store(true, std::memory_order_relaxed);
}

Rest::Record& Rest::recordOf(const btCollisionObject& object) const {
  assert(object.getIslandTag() >= 0 && static_cast<std::size_t>(object.getIslandTag()) < count_);
  return records_[static_cast<std::size_t>(object.getIslandTag())];
}

Rest::UnchangedIsland Rest::islandOf(std::span<btRigidBody* const> bodies,
                                     std::span<btPersistentManifold* const> manifolds) {
  UnchangedIsland island{bodies.front(), bodies.size(), manifolds.size(), 0};
  for (const btPersistentManifold* manifold : manifolds) island.points += manifold->getNumContacts();
  return island;
}

bool Rest::isSettled(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds) const {
  // most are not settled, which is known at once
  if (recordOf(*bodies.front()).island.bodies == 0) return false;
  const UnchangedIsland now = islandOf(bodies, manifolds);
  return std::ranges::all_of(bodies, [&](const btRigidBody* each) {
    const btRigidBody& body = *each;
    const Record& record = recordOf(body);
    return record.island == now && !record.isDisturbed.load(std::memory_order_relaxed) &&
           isSame(record.linear, body.getLinearVelocity()) && isSame(record.angular, body.getAngularVelocity()) &&
           isSame(record.force, body.getTotalForce()) && isSame(record.torque, body.getTotalTorque());
  });
}

void Rest::begin(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds, bool hasJoints,
                 Snapshot& snapshot) {
  for (const btRigidBody* body : bodies) {
    snapshot.poses.push_back(body->getWorldTransform());
    // an island with joints is always solved
    if (hasJoints) continue;
    Record& record = recordOf(*body);
    record.linear = body->getLinearVelocity();
    record.angular = body->getAngularVelocity();
    record.force = body->getTotalForce();
    record.torque = body->getTotalTorque();
  }
  if (hasJoints) return;
  forEachImpulse(manifolds, [&](double impulse) { snapshot.impulses.push_back(impulse); });
}

void Rest::end(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds, bool hasJoints,
               const Snapshot& snapshot, const Snapshot::Start& start) {
  bool isUnchanged = !hasJoints;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const btRigidBody& body = *bodies[i];
    Record& record = recordOf(body);
    record.isDisturbed.store(false, std::memory_order_relaxed);
    record.isStill = isSame(snapshot.poses[start.poses + i], body.getWorldTransform());
    isUnchanged = isUnchanged && record.isStill && isSame(record.linear, body.getLinearVelocity()) &&
                  isSame(record.angular, body.getAngularVelocity());
    // damping changes velocities between the steps
    if (body.getLinearDamping() != 0 || body.getAngularDamping() != 0) isUnchanged = false;
  }
  if (isUnchanged) {
    std::size_t next = start.impulses;
    forEachImpulse(manifolds, [&](double impulse) {
      isUnchanged = isUnchanged && std::memcmp(&impulse, &snapshot.impulses[next], sizeof(impulse)) == 0;
      ++next;
    });
  }
  const UnchangedIsland island = isUnchanged ? islandOf(bodies, manifolds) : UnchangedIsland();
  for (const btRigidBody* body : bodies) recordOf(*body).island = island;
}

}  // namespace pongsim::physics
