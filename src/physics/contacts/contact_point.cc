#include "physics/contacts/contact_point.hh"

#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>

#include <optional>

#include "physics/solving/bounce.hh"
#include "physics/solving/friction.hh"

namespace pongsim::physics {

PointFriction settlePoint(btManifoldPoint& point, const btPersistentManifold& manifold) {
  PointFriction found;
  point.m_contactPointFlags &=
      ~(BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING | BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED);
  if (const std::optional<PointSurface> surface = pointSurface(manifold, point)) {
    point.m_combinedRestitution = restitutionAt(manifold, point, *surface);
    if (surface->isSoft) {
      point.m_contactPointFlags |= BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING;
      point.m_combinedContactStiffness1 = surface->stiffness;
      point.m_combinedContactDamping1 = surface->damping;
    }
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

}  // namespace pongsim::physics
