#include "physics/collision_configuration.hh"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <new>

namespace pongsim::physics {

namespace {

/// How often a body is tilted a little, to find more corners, and below how many points it is.
constexpr int kTilts = 4;

/// @return A lower bound of a hull's or box's distance from a plane: that of the box around it.
btScalar leastDistance(const btCollisionObjectWrapper& hull, const btCollisionObjectWrapper& plane) {
  const auto& ground = static_cast<const btStaticPlaneShape&>(*plane.getCollisionShape());
  btVector3 low, high;
  hull.getCollisionShape()->getAabb(btTransform::getIdentity(), low, high);
  // the normal as the hull sees it
  const btVector3 normal = plane.getWorldTransform().getBasis() * ground.getPlaneNormal();
  const btVector3 own = normal * hull.getWorldTransform().getBasis();
  const btVector3 middle = hull.getWorldTransform() * ((low + high) / 2);
  const btScalar reach = own.absolute().dot((high - low) / 2);
  return normal.dot(middle - plane.getWorldTransform().getOrigin()) - ground.getPlaneConstant() - reach;
}

class HullOnPlane final : public btConvexPlaneCollisionAlgorithm {
 public:
  using btConvexPlaneCollisionAlgorithm::btConvexPlaneCollisionAlgorithm;

  void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                        const btDispatcherInfo& info, btManifoldResult* result) override {
    const bool isPlaneFirst = a->getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE;
    // one of a thread, for a step allocates nothing
    thread_local btManifoldArray manifolds;
    manifolds.resizeNoInitialize(0);
    getAllContactManifolds(manifolds);
    // where there are points, Bullet forgets those that are far
    const bool isEmpty = manifolds.size() == 1 && manifolds[0]->getNumContacts() == 0;
    if (isEmpty &&
        leastDistance(isPlaneFirst ? *b : *a, isPlaneFirst ? *a : *b) > manifolds[0]->getContactBreakingThreshold()) {
      return;
    }
    btConvexPlaneCollisionAlgorithm::processCollision(a, b, info, result);
  }
};

}  // namespace

btCollisionAlgorithm* CollisionConfiguration::MakeHullOnPlane::CreateCollisionAlgorithm(
    btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b) {
  static_assert(sizeof(HullOnPlane) == sizeof(btConvexPlaneCollisionAlgorithm), "the pool's places are of that size");
  void* place = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(HullOnPlane));
  return new (place)
      HullOnPlane(nullptr, info, a, b, m_swapped, m_numPerturbationIterations, m_minimumPointsPerturbationThreshold);
}

CollisionConfiguration::CollisionConfiguration() {
  setPlaneConvexMultipointIterations(kTilts, kTilts);
  for (MakeHullOnPlane* make : {&hullOnPlane_, &planeUnderHull_}) {
    make->m_numPerturbationIterations = kTilts;
    make->m_minimumPointsPerturbationThreshold = kTilts;
  }
  planeUnderHull_.m_swapped = true;
}

btCollisionAlgorithmCreateFunc* CollisionConfiguration::getCollisionAlgorithmCreateFunc(int typeA, int typeB) {
  const auto hasCorners = [](int type) { return type == CONVEX_HULL_SHAPE_PROXYTYPE || type == BOX_SHAPE_PROXYTYPE; };
  if (hasCorners(typeA) && typeB == STATIC_PLANE_PROXYTYPE) return &hullOnPlane_;
  if (typeA == STATIC_PLANE_PROXYTYPE && hasCorners(typeB)) return &planeUnderHull_;
  return btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(typeA, typeB);
}

}  // namespace pongsim::physics
