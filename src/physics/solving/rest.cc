#include "physics/solving/rest.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cstring>

namespace pongsim::physics {

namespace {

bool isSame(const btVector3& a, const btVector3& b) { return std::memcmp(&a[0], &b[0], 3 * sizeof(btScalar)) == 0; }

bool isSame(const btTransform& a, const btTransform& b) {
  return isSame(a.getOrigin(), b.getOrigin()) && isSame(a.getBasis()[0], b.getBasis()[0]) &&
         isSame(a.getBasis()[1], b.getBasis()[1]) && isSame(a.getBasis()[2], b.getBasis()[2]);
}

const btRigidBody& rigidOf(const btCollisionObject& object) { return static_cast<const btRigidBody&>(object); }

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
    records_[i].group = {};
  }
}

bool Rest::isStill(const btCollisionObject& object) const {
  return object.getIslandTag() < 0 ? object.isStaticObject() : recordOf(object).isStill;
}

void Rest::disturb(const btCollisionObject& object) {
  if (object.getIslandTag() >= 0) recordOf(object).isDisturbed.store(true, std::memory_order_relaxed);
}

Rest::Group Rest::groupOf(std::span<btCollisionObject* const> bodies,
                          std::span<btPersistentManifold* const> manifolds) {
  Group group{bodies.front(), bodies.size(), manifolds.size(), 0};
  for (const btPersistentManifold* manifold : manifolds) group.points += manifold->getNumContacts();
  return group;
}

bool Rest::isSettled(std::span<btCollisionObject* const> bodies,
                     std::span<btPersistentManifold* const> manifolds) const {
  // most are not, and are found out at once
  if (recordOf(*bodies.front()).group.bodies == 0) return false;
  const Group now = groupOf(bodies, manifolds);
  return std::ranges::all_of(bodies, [&](const btCollisionObject* object) {
    const btRigidBody& body = rigidOf(*object);
    const Record& record = recordOf(body);
    return record.group == now && !record.isDisturbed.load(std::memory_order_relaxed) &&
           isSame(record.linear, body.getLinearVelocity()) && isSame(record.angular, body.getAngularVelocity()) &&
           isSame(record.force, body.getTotalForce()) && isSame(record.torque, body.getTotalTorque());
  });
}

void Rest::begin(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds,
                 bool hasJoints, Before& before) {
  for (const btCollisionObject* object : bodies) {
    const btRigidBody& body = rigidOf(*object);
    before.places.push_back(body.getWorldTransform());
    // is never left as it is
    if (hasJoints) continue;
    Record& record = recordOf(body);
    record.linear = body.getLinearVelocity();
    record.angular = body.getAngularVelocity();
    record.force = body.getTotalForce();
    record.torque = body.getTotalTorque();
  }
  if (hasJoints) return;
  forEachImpulse(manifolds, [&](double impulse) { before.impulses.push_back(impulse); });
}

void Rest::end(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds,
               bool hasJoints, const Before& before, const Before::Start& start) {
  bool isUnchanged = !hasJoints;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const btRigidBody& body = rigidOf(*bodies[i]);
    Record& record = recordOf(body);
    record.isDisturbed.store(false, std::memory_order_relaxed);
    record.isStill = isSame(before.places[start.places + i], body.getWorldTransform());
    isUnchanged = isUnchanged && record.isStill && isSame(record.linear, body.getLinearVelocity()) &&
                  isSame(record.angular, body.getAngularVelocity());
    // what is damped is slowed down between the steps
    if (body.getLinearDamping() != 0 || body.getAngularDamping() != 0) isUnchanged = false;
  }
  if (isUnchanged) {
    std::size_t next = start.impulses;
    forEachImpulse(manifolds, [&](double impulse) {
      isUnchanged = isUnchanged && std::memcmp(&impulse, &before.impulses[next], sizeof(impulse)) == 0;
      ++next;
    });
  }
  const Group group = isUnchanged ? groupOf(bodies, manifolds) : Group();
  for (const btCollisionObject* object : bodies) recordOf(*object).group = group;
}

}  // namespace pongsim::physics
