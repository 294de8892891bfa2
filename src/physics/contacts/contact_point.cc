#include "physics/contacts/contact_point.hh"

#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cassert>
#include <cmath>
#include <optional>

#include "physics/contacts/bounce.hh"
#include "physics/contacts/friction.hh"

namespace pongsim::physics {

PointFriction settlePoint(btManifoldPoint& point, const btPersistentManifold& manifold) {
  PointFriction found;
  if (const std::optional<PointSurface> surface = pointSurface(manifold, point)) {
    point.m_combinedRestitution = restitutionAt(manifold, point, *surface);
    found.torsion = surface->torsion;
    found.torsionSlip = surface->torsionSlip;
  }
  if (const std::optional<DirectedFriction> friction = directedFriction(manifold, point)) {
    point.m_combinedFriction = friction->mu;
    point.m_lateralFrictionDir1 = friction->direction;
    point.m_lateralFrictionDir2 = point.m_normalWorldOnB.cross(friction->direction);
    point.m_contactMotion1 = friction->motion1;
    point.m_contactMotion2 = friction->motion2;
    found.isDirected = true;
    found.mu2 = friction->mu2;
    found.slip1 = friction->slip1;
    found.slip2 = friction->slip2;
  }
  return found;
}

namespace {

/// The place where both bodies feel the contact's forces. Bullet has two, apart by the depth; forces at two places
/// would be a torque on the bodies together, and deep in each other friction would stop them from turning.
btVector3 placeOf(const btManifoldPoint& point, const btPersistentManifold& manifold) {
  const btVector3& onA = point.getPositionWorldOnA();
  const btVector3& onB = point.getPositionWorldOnB();
  if (manifold.getBody1()->isStaticOrKinematicObject()) return onA;
  if (manifold.getBody0()->isStaticOrKinematicObject()) return onB;
  return (onA + onB) * 0.5;
}

}  // namespace

SolverContact::SolverContact(btManifoldPoint& pointOfManifold, const btPersistentManifold& manifold)
    : point(pointOfManifold),
      a(*btRigidBody::upcast(manifold.getBody0())),
      b(*btRigidBody::upcast(manifold.getBody1())),
      armA(placeOf(point, manifold) - a.getWorldTransform().getOrigin()),
      armB(placeOf(point, manifold) - b.getWorldTransform().getOrigin()),
      friction(settlePoint(point, manifold)) {
  assert(std::abs(point.m_normalWorldOnB.length2() - 1) < 1e-6);
  if (friction.isDirected) return;
  point.m_contactMotion1 = point.m_contactMotion2 = 0;
  friction.mu2 = point.m_combinedFriction;
}

void SolverContact::chooseDirections(const btVector3& velocity) const {
  const btVector3& normal = point.m_normalWorldOnB;
  const btVector3 sliding = velocity - normal * normal.dot(velocity);
  const double speed2 = sliding.length2();
  if (speed2 > SIMD_EPSILON) {
    point.m_lateralFrictionDir1 = sliding * (1 / std::sqrt(speed2));
    point.m_lateralFrictionDir2 = point.m_lateralFrictionDir1.cross(normal).normalize();
  } else {
    btPlaneSpace1(normal, point.m_lateralFrictionDir1, point.m_lateralFrictionDir2);
  }
}

}  // namespace pongsim::physics
