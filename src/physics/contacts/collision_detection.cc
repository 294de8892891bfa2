#include "physics/contacts/collision_detection.hh"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <cassert>

namespace pongsim::physics {

void CollisionDetection::setFilter(btOverlapFilterCallback& filter) {
  broadPhase_.getOverlappingPairCache()->setOverlapFilterCallback(&filter);
}

void CollisionDetection::add(btRigidBody& body, int number) {
  assert(body.getBroadphaseHandle() == nullptr);
  btVector3 lowest, highest;
  body.getCollisionShape()->getAabb(body.getWorldTransform(), lowest, highest);
  body.setBroadphaseHandle(&broadPhase_.add(lowest, highest, &body, !body.isStaticOrKinematicObject(), number));
}

void CollisionDetection::remove(std::span<btRigidBody* const> bodies) {
  if (bodies.empty()) return;
  // a mark on the bodies instead of a list of them, for this must not allocate
  constexpr int kGoes = -2;
  for (btRigidBody* body : bodies) body->setIslandTag(kGoes);
  const auto goes = [](const btBroadphaseProxy& proxy) {
    return static_cast<const btCollisionObject*>(proxy.m_clientObject)->getIslandTag() == kGoes;
  };
  broadPhase_.removePairs(goes, dispatcher_);
  for (btRigidBody* body : bodies) {
    broadPhase_.destroyProxy(body->getBroadphaseHandle(), &dispatcher_);
    body->setBroadphaseHandle(nullptr);
    body->setIslandTag(-1);
  }
}

void CollisionDetection::moved(btRigidBody& body) {
  btBroadphaseProxy* const proxy = body.getBroadphaseHandle();
  if (proxy == nullptr) return;
  boxes_.updateInPlace(body);
  if (body.getIslandTag() >= 0) boxes_.forget(static_cast<std::size_t>(body.getIslandTag()));
  broadPhase_.getOverlappingPairCache()->cleanProxyFromPairs(proxy, &dispatcher_);
}

void CollisionDetection::separate(btRigidBody& a, btRigidBody& b) {
  if (a.getBroadphaseHandle() == nullptr || b.getBroadphaseHandle() == nullptr) return;
  broadPhase_.getOverlappingPairCache()->removeOverlappingPair(a.getBroadphaseHandle(), b.getBroadphaseHandle(),
                                                               &dispatcher_);
}

void CollisionDetection::findPairsOf(btRigidBody& body) {
  if (body.getBroadphaseHandle() != nullptr) broadPhase_.findPairs(*body.getBroadphaseHandle());
}

void CollisionDetection::findTouches(std::span<btRigidBody* const> moving, const btDispatcherInfo& info) {
  boxes_.updateInPlace(moving);
  broadPhase_.optimize();
  dispatcher_.dispatchAllCollisionPairs(broadPhase_.getOverlappingPairCache(), info, &dispatcher_);
}

}  // namespace pongsim::physics
