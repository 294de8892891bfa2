#include "physics/contacts/swept_boxes.hh"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace pongsim::physics {

namespace {

/// Bodies that a worker takes at a time: fetching them one by one costs too much.
constexpr std::size_t kBodiesAtATime = 16;

/// A new fat box has room for the motion of this time [s], but no more than the body's own size.
constexpr double kAhead = 0.1;

// The pose after `dt`, for the box only: R + [dt w] R, to first order, which is too large by half the square of the
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

/// @return The box that holds the body where it is now and where it will be.
Aabb aabbOf(const btRigidBody& body, const btTransform& then) {
  Aabb now, later;
  body.getCollisionShape()->getAabb(body.getWorldTransform(), now.lowest, now.highest);
  body.getCollisionShape()->getAabb(then, later.lowest, later.highest);
  now.lowest.setMin(later.lowest);
  now.highest.setMax(later.highest);
  const btVector3 margin(gContactBreakingThreshold, gContactBreakingThreshold, gContactBreakingThreshold);
  return {now.lowest - margin, now.highest + margin};
}

/// @return Whether the broad phase can take the box: it has numbers, and is not larger than 1000 km.
bool isReasonable(const Aabb& aabb) {
  constexpr double kLargest = 1e6;
  return (aabb.highest - aabb.lowest).length2() < kLargest * kLargest;
}

/// @return The expected displacement within `kAhead`.
btVector3 motionAhead(const btRigidBody& body) {
  const btBroadphaseProxy& proxy = *body.getBroadphaseProxy();
  const btVector3 most = proxy.m_aabbMax - proxy.m_aabbMin;
  btVector3 motion = body.getLinearVelocity() * kAhead;
  motion.setMax(-most);
  motion.setMin(most);
  return motion;
}

}  // namespace

void SweptBoxes::resize(std::size_t kept, std::size_t bodies) {
  within_.resize(std::min(kept, within_.size()));
  within_.resize(bodies, Within::kUnknown);
  isOneUnknown_ = true;
}

SweptBoxes::Within SweptBoxes::withinFatBox(btRigidBody& body, const btTransform& then) {
  const Aabb aabb = aabbOf(body, then);
  if (!isReasonable(aabb)) return Within::kTooFast;
  const bool isWithin = BroadPhase::updateAabb(*body.getBroadphaseProxy(), aabb.lowest, aabb.highest);
  return isWithin ? Within::kYes : Within::kNo;
}

void SweptBoxes::sweep(btRigidBody& body, std::size_t number, double dt) {
  within_[number] = withinFatBox(body, roughlyMoved(body, dt));
}

void SweptBoxes::forget(std::size_t number) {
  within_[number] = Within::kUnknown;
  isOneUnknown_ = true;
}

template <class Work>
void SweptBoxes::forEach(std::span<btRigidBody* const> bodies, Work&& work) {
  workers_.forEach((bodies.size() + kBodiesAtATime - 1) / kBodiesAtATime, [&](std::size_t chunk, int) {
    const std::size_t end = std::min(bodies.size(), (chunk + 1) * kBodiesAtATime);
    for (std::size_t i = chunk * kBodiesAtATime; i < end; ++i) work(*bodies[i], i);
  });
}

void SweptBoxes::update(std::span<btRigidBody* const> bodies, double dt) {
  assert(bodies.size() == within_.size());
  const bool areOfOtherStep = std::exchange(dt_, dt) != dt;
  if (std::exchange(isOneUnknown_, false) || areOfOtherStep) {
    forEach(bodies, [&](btRigidBody& body, std::size_t i) {
      if (areOfOtherStep || within_[i] == Within::kUnknown) sweep(body, i, dt);
    });
  }
  fattenBoxes(bodies);
}

void SweptBoxes::updateInPlace(std::span<btRigidBody* const> bodies) {
  forEach(bodies, [&](btRigidBody& body, std::size_t i) { within_[i] = withinFatBox(body, body.getWorldTransform()); });
  fattenBoxes(bodies);
  resize(0, bodies.size());
}

void SweptBoxes::updateInPlace(btRigidBody& body) {
  const Aabb aabb = aabbOf(body, body.getWorldTransform());
  if (!body.isStaticObject() && !isReasonable(aabb)) return;
  broadPhase_.setAabb(body.getBroadphaseProxy(), aabb.lowest, aabb.highest, nullptr);
}

void SweptBoxes::fattenBoxes(std::span<btRigidBody* const> bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (within_[i] == Within::kTooFast) updateInPlace(*bodies[i]);
    if (within_[i] == Within::kNo) broadPhase_.fattenAabb(*bodies[i]->getBroadphaseProxy(), motionAhead(*bodies[i]));
    within_[i] = Within::kYes;
  }
}

}  // namespace pongsim::physics
