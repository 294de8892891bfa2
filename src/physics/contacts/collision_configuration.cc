#include "physics/contacts/collision_configuration.hh"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <numbers>

#include "physics/motion.hh"

namespace pongsim::physics {

namespace {

/// How many times a body is tilted slightly to find more corners; done only if it has fewer contact points than this.
constexpr int kTilts = 4;

/// @return A lower bound on the distance of a hull or box from a plane, computed from its bounding box.
btScalar leastDistance(const btCollisionObjectWrapper& hull, const btCollisionObjectWrapper& plane) {
  const auto& ground = static_cast<const btStaticPlaneShape&>(*plane.getCollisionShape());
  btVector3 low, high;
  hull.getCollisionShape()->getAabb(btTransform::getIdentity(), low, high);
  // the normal in the frame of the hull
  const btVector3 normal = plane.getWorldTransform().getBasis() * ground.getPlaneNormal();
  const btVector3 own = normal * hull.getWorldTransform().getBasis();
  const btVector3 middle = hull.getWorldTransform() * ((low + high) / 2);
  const btScalar reach = own.absolute().dot((high - low) / 2);
  return normal.dot(middle - plane.getWorldTransform().getOrigin()) - ground.getPlaneConstant() - reach;
}

/// Finds all corners of a body that touch a plane in one step, rather than one corner a step. With few known points it
/// tilts the body slightly in several directions, as btConvexPlaneCollisionAlgorithm does, but without the C library's
/// sine.
class ConvexOnPlane final : public btConvexPlaneCollisionAlgorithm {
 public:
  ConvexOnPlane(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
                const btCollisionObjectWrapper* b, bool isPlaneFirst)
      : btConvexPlaneCollisionAlgorithm(nullptr, info, a, b, isPlaneFirst, 0, 0) {}

  void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                        const btDispatcherInfo& info, btManifoldResult* result) override {
    // one for each thread, because a step must not allocate
    thread_local btManifoldArray manifolds;
    manifolds.resizeNoInitialize(0);
    getAllContactManifolds(manifolds);
    // empty if the two do not touch
    if (manifolds.size() == 0) return;
    const btPersistentManifold& manifold = *manifolds[0];
    const bool isPlaneFirst = a->getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE;
    const btCollisionObjectWrapper& convex = isPlaneFirst ? *b : *a;
    const btCollisionObjectWrapper& plane = isPlaneFirst ? *a : *b;
    const int type = convex.getCollisionShape()->getShapeType();
    const bool hasCorners = type == CONVEX_HULL_SHAPE_PROXYTYPE || type == BOX_SHAPE_PROXYTYPE;
    // if there are points, Bullet drops the distant ones
    if (manifold.getNumContacts() == 0 && hasCorners &&
        leastDistance(convex, plane) > manifold.getContactBreakingThreshold()) {
      return;
    }
    collideSingleContact(btQuaternion::getIdentity(), a, b, info, result);
    // extra points on a round shape would lie off centre and keep it rolling for ever
    if (convex.getCollisionShape()->isPolyhedral() && manifold.getNumContacts() < kTilts) {
      for (const btQuaternion& tilt : tiltsOf(convex, plane)) collideSingleContact(tilt, a, b, info, result);
    }
    if (manifold.getNumContacts() > 0) result->refreshContactPoints();
  }

 private:
  static std::array<btQuaternion, kTilts> tiltsOf(const btCollisionObjectWrapper& convex,
                                                  const btCollisionObjectWrapper& plane) {
    const btVector3& normal = static_cast<const btStaticPlaneShape&>(*plane.getCollisionShape()).getPlaneNormal();
    btVector3 level, across;
    btPlaneSpace1(normal, level, across);
    // the outermost corner moves by the contact threshold
    const double reach = static_cast<const btConvexShape&>(*convex.getCollisionShape()).getAngularMotionDisc();
    const btQuaternion tilt = turnAbout(level, std::min(gContactBreakingThreshold / reach, std::numbers::pi / 8));
    std::array<btQuaternion, kTilts> tilts;
    for (int i = 0; i < kTilts; ++i) {
      const btQuaternion turn = turnAbout(normal, i * (2 * std::numbers::pi / kTilts));
      tilts[static_cast<std::size_t>(i)] = turn.inverse() * tilt * turn;
    }
    return tilts;
  }
};

btDefaultCollisionConstructionInfo withoutPools() {
  btDefaultCollisionConstructionInfo info;
  // a pool has one place at least
  info.m_defaultMaxPersistentManifoldPoolSize = 1;
  info.m_defaultMaxCollisionAlgorithmPoolSize = 1;
  return info;
}

}  // namespace

CollisionConfiguration::CollisionConfiguration() : btDefaultCollisionConfiguration(withoutPools()) {
  planeUnderConvex_.m_swapped = true;
}

btCollisionAlgorithm* CollisionConfiguration::MakeConvexOnPlane::CreateCollisionAlgorithm(
    btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b) {
  static_assert(sizeof(ConvexOnPlane) == sizeof(btConvexPlaneCollisionAlgorithm), "the pool's places are of that size");
  void* place = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(ConvexOnPlane));
  return new (place) ConvexOnPlane(info, a, b, m_swapped);
}

btCollisionAlgorithmCreateFunc* CollisionConfiguration::getCollisionAlgorithmCreateFunc(int typeA, int typeB) {
  if (btBroadphaseProxy::isConvex(typeA) && typeB == STATIC_PLANE_PROXYTYPE) return &convexOnPlane_;
  if (typeA == STATIC_PLANE_PROXYTYPE && btBroadphaseProxy::isConvex(typeB)) return &planeUnderConvex_;
  return btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(typeA, typeB);
}

}  // namespace pongsim::physics
