#include "physics/contacts/bounce.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "physics/contacts/friction.hh"

namespace pongsim::physics {

namespace {

btVector3 velocityOfPoint(const btRigidBody& body, const btVector3& position) {
  return body.getVelocityInLocalPoint(position - body.getCenterOfMassPosition());
}

/// @return The speed of approach at the point [m/s].
double approachAt(const btManifoldPoint& point, const btRigidBody& a, const btRigidBody& b) {
  const btVector3 velocity =
      velocityOfPoint(a, point.getPositionWorldOnA()) - velocityOfPoint(b, point.getPositionWorldOnB());
  return -point.m_normalWorldOnB.dot(velocity);
}

}  // namespace

double restitutionAt(const btPersistentManifold& manifold, const btManifoldPoint& point, const PointSurface& surface) {
  if (surface.restitution <= 0) return surface.restitution;
  const double approach =
      approachAt(point, *btRigidBody::upcast(manifold.getBody0()), *btRigidBody::upcast(manifold.getBody1()));
  return approach < surface.bounceThreshold ? 0 : surface.restitution;
}

double bounceChange(const btManifoldPoint& point, const btRigidBody& a, const btRigidBody& b, double dt) {
  if (point.m_combinedRestitution <= 0 || point.getDistance() <= 0) return 0;
  const double approach = approachAt(point, a, b);
  const double gapRate = point.getDistance() / dt;
  return gapRate < approach ? gapRate : -point.m_combinedRestitution * approach;
}

}  // namespace pongsim::physics
