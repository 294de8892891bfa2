#include "physics/contacts/swept_boxes.hh"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <utility>

namespace pongsim::physics {

namespace {

/// How many a worker takes at a time: one is too little to be worth the asking.
constexpr std::size_t kBodiesAtATime = 16;

/// For how long a body that has left its box gets room in its new one [s], but for no more than its own size.
constexpr double kAhead = 0.1;

// Where it will be after `dt`, for its box only: turned to first order, which makes it larger by half the square of the
// angle.
btTransform roughlyMoved(const btRigidBody& body, double dt) {
  const btTransform& now = body.getWorldTransform();
  const btMatrix3x3& R = now.getBasis();
  const btVector3 turn = body.getAngularVelocity() * dt;
  const btMatrix3x3 turned(R[0] + turn.y() * R[2] - turn.z() * R[1], R[1] + turn.z() * R[0] - turn.x() * R[2],
                           R[2] + turn.x() * R[1] - turn.y() * R[0]);
  return btTransform(turned, now.getOrigin() + body.getLinearVelocity() * dt);
}

struct Aabb {
  btVector3 lowest;
  btVector3 highest;
};

/// @return What holds the body where it is now and where it is going.
Aabb aabbOf(const btRigidBody& body, const btTransform& then) {
  Aabb now, later;
  body.getCollisionShape()->getAabb(body.getWorldTransform(), now.lowest, now.highest);
  body.getCollisionShape()->getAabb(then, later.lowest, later.highest);
  now.lowest.setMin(later.lowest);
  now.highest.setMax(later.highest);
  const btVector3 margin(gContactBreakingThreshold, gContactBreakingThreshold, gContactBreakingThreshold);
  return {now.lowest - margin, now.highest + margin};
}

btVector3 wayAhead(const btRigidBody& body) {
  const btBroadphaseProxy& proxy = *body.getBroadphaseProxy();
  const btVector3 most = proxy.m_aabbMax - proxy.m_aabbMin;
  btVector3 way = body.getLinearVelocity() * kAhead;
  way.setMax(-most);
  way.setMin(most);
  return way;
}

}  // namespace

void SweptBoxes::resize(std::size_t kept, std::size_t bodies) {
  stays_.resize(std::min(kept, stays_.size()));
  stays_.resize(bodies, Stay::kUnknown);
  isOneUnknown_ = true;
}

SweptBoxes::Stay SweptBoxes::stayOf(btRigidBody& body, const btTransform& then) {
  // Bullet has its own way with what is as large as that, or not a number
  constexpr double kSanest = 1e12;
  const Aabb aabb = aabbOf(body, then);
  if (!((aabb.highest - aabb.lowest).length2() < kSanest)) return Stay::kAbsurd;
  return BroadPhase::stay(*body.getBroadphaseProxy(), aabb.lowest, aabb.highest) ? Stay::kYes : Stay::kNo;
}

void SweptBoxes::sweep(btRigidBody& body, std::size_t number, double dt) {
  stays_[number] = stayOf(body, roughlyMoved(body, dt));
}

void SweptBoxes::forget(std::size_t number) {
  stays_[number] = Stay::kUnknown;
  isOneUnknown_ = true;
}

template <class Work>
void SweptBoxes::forEach(std::span<btRigidBody* const> bodies, Work&& work) {
  workers_.forEach((bodies.size() + kBodiesAtATime - 1) / kBodiesAtATime, [&](std::size_t chunk, int) {
    const std::size_t end = std::min(bodies.size(), (chunk + 1) * kBodiesAtATime);
    for (std::size_t i = chunk * kBodiesAtATime; i < end; ++i) work(*bodies[i], i);
  });
}

void SweptBoxes::update(std::span<btRigidBody* const> bodies, double dt, btCollisionWorld& world) {
  const bool areOfOtherStep = std::exchange(dt_, dt) != dt;
  if (std::exchange(isOneUnknown_, false) || areOfOtherStep) {
    forEach(bodies, [&](btRigidBody& body, std::size_t i) {
      if (areOfOtherStep || stays_[i] == Stay::kUnknown) sweep(body, i, dt);
    });
  }
  putThoseThatLeft(bodies, world);
}

void SweptBoxes::updateInPlace(std::span<btRigidBody* const> bodies, btCollisionWorld& world) {
  forEach(bodies, [&](btRigidBody& body, std::size_t i) { stays_[i] = stayOf(body, body.getWorldTransform()); });
  putThoseThatLeft(bodies, world);
  resize(0, bodies.size());
}

void SweptBoxes::putThoseThatLeft(std::span<btRigidBody* const> bodies, btCollisionWorld& world) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (stays_[i] == Stay::kYes) continue;
    if (stays_[i] == Stay::kNo) broadPhase_.leave(*bodies[i]->getBroadphaseProxy(), wayAhead(*bodies[i]));
    if (stays_[i] == Stay::kAbsurd) world.updateSingleAabb(bodies[i]);
    stays_[i] = Stay::kYes;
  }
}

}  // namespace pongsim::physics
