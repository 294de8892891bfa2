#include "physics/contacts/friction.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "physics/contacts/surface.hh"
#include "physics/convert.hh"
#include "physics/shapes/shape.hh"

namespace pongsim::physics {

namespace {

// a direction whose angle to the normal has a smaller sine has no direction along the surface
constexpr double kLeastTangentSine = 1e-3;

/// @return The collision that a point belongs to; null for a body that is not ours.
const LinkShape::Part* collisionAt(const btCollisionObject& object, int number) {
  const auto* shape = static_cast<const LinkShape*>(object.getUserPointer());
  return shape == nullptr ? nullptr : &shape->part(static_cast<std::size_t>(number));
}

/// @return What the description says of the collision that a point belongs to; null for a body that is not ours. A
/// shape of one part says it, and is in the processor's caches where many have the same.
const description::Surface* surfaceAt(const btCollisionObject& object, int number) {
  const btCollisionShape* shape = object.getCollisionShape();
  if (shape != nullptr && shape->getUserPointer() != nullptr) return &surfaceOf(*shape);
  const LinkShape::Part* part = collisionAt(object, number);
  return part == nullptr ? nullptr : part->surface;
}

btVector3 worldDirection(const btCollisionObject& object, const LinkShape::Part& part) {
  if (part.fdir1_World) return toBullet(*part.fdir1_World);
  return object.getWorldTransform().getBasis() * toBullet(Vector3(part.q_BodyCollision * part.surface->fdir1));
}

/// @return The part of it in the tangent plane, as a unit vector; nothing where it lies along the normal.
std::optional<btVector3> alongSurface(const btVector3& direction, const btVector3& normal) {
  const btVector3 tangent = direction - normal * normal.dot(direction);
  const double length = tangent.length();
  if (length <= kLeastTangentSine * direction.length()) return std::nullopt;
  return tangent / length;
}

/// The motion of a surface at a point: a unit vector in the tangent plane, and the speed [m/s].
struct Run {
  btVector3 direction;
  double speed;
};

/// @param inwards The normal into the collision.
/// @return Nothing where the surface does not run.
std::optional<Run> runOf(const LinkShape::Part& part, const btCollisionObject& object, const btVector3& position,
                         const btVector3& inwards) {
  if (!part.motion) return std::nullopt;
  const btVector3 axis = object.getWorldTransform().getBasis() * toBullet(part.motion->axis);
  btVector3 direction = inwards.cross(axis);
  if (direction.length() <= kLeastTangentSine) return std::nullopt;
  direction.normalize();
  if (!part.motion->center) return Run{direction, part.motion->speed};
  const btVector3 arm = position - toBullet(*part.motion->center);
  const btVector3 tangent = inwards.cross(arm);
  // the centre itself does not move
  if (tangent.length() <= kLeastTangentSine * arm.length()) return Run{direction, 0};
  const double along = direction.dot(tangent);
  const double sign = along > 0 ? 1 : along < 0 ? -1 : 0;
  return Run{tangent.normalized(), sign * part.motion->speed};
}

/// Sets the direction and velocities of friction on moving surfaces.
/// @return Whether any surface moves.
bool takeAlong(DirectedFriction& friction, const btPersistentManifold& manifold, const btManifoldPoint& point,
               const LinkShape::Part& a, const LinkShape::Part& b) {
  const btVector3& normal = point.m_normalWorldOnB;
  const auto runA = runOf(a, *manifold.getBody0(), point.getPositionWorldOnA(), normal);
  const auto runB = runOf(b, *manifold.getBody1(), point.getPositionWorldOnB(), -normal);
  if (!runA && !runB) return false;
  friction.direction = runA ? runA->direction : runB->direction;
  // no sliding between the surfaces: vA + uA = vB + uB
  btVector3 wanted(0, 0, 0);
  if (runB) wanted += runB->direction * runB->speed;
  if (runA) wanted -= runA->direction * runA->speed;
  friction.motion1 = wanted.dot(friction.direction);
  friction.motion2 = wanted.dot(normal.cross(friction.direction));
  return true;
}

// default of the speed below which nothing bounces [m/s]
constexpr double kBounceThreshold = 0.1;

// A patch that is pressed as a ball on a plane (Hertz) and slides all over resists by 3 pi / 16 of radius, coefficient
// and force. Of two, the larger patch and the smaller coefficient count, and the curvatures add up, as in Gazebo
// classic.
double torsionOf(const description::Torsion& one, const description::Torsion& other, double depth) {
  double radius = std::max(one.patchRadius, other.patchRadius);
  if (!one.usesPatchRadius || !other.usesPatchRadius) {
    const auto curvature = [](double r) { return r > 0 ? 1 / r : 0; };
    const double sum = curvature(one.surfaceRadius) + curvature(other.surfaceRadius);
    radius = sum > 0 ? std::sqrt(std::max(depth, 0.0) / sum) : 0;
  }
  return 3 * std::numbers::pi / 16 * radius * std::min(one.coefficient, other.coefficient);
}

}  // namespace

std::optional<PointSurface> pointSurface(const btPersistentManifold& manifold, const btManifoldPoint& point) {
  const LinkShape::Part* a = collisionAt(*manifold.getBody0(), point.m_index0);
  const LinkShape::Part* b = collisionAt(*manifold.getBody1(), point.m_index1);
  if (a == nullptr || b == nullptr) return std::nullopt;
  const description::Surface& one = *a->surface;
  const description::Surface& other = *b->surface;
  PointSurface result;
  result.restitution = one.restitution * other.restitution;
  result.bounceThreshold = kBounceThreshold;
  if (one.bounceThreshold || other.bounceThreshold) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    result.bounceThreshold = std::min(one.bounceThreshold.value_or(kNone), other.bounceThreshold.value_or(kNone));
  }
  result.torsion = torsionOf(one.torsion, other.torsion, -point.getDistance());
  result.torsionSlip = one.torsion.slip + other.torsion.slip;
  return result;
}

long long mostContacts(const btPersistentManifold& manifold, long long otherwise) {
  if (manifold.getNumContacts() == 0) return otherwise;
  const btManifoldPoint& point = manifold.getContactPoint(0);
  const description::Surface* a = surfaceAt(*manifold.getBody0(), point.m_index0);
  const description::Surface* b = surfaceAt(*manifold.getBody1(), point.m_index1);
  if (a == nullptr || b == nullptr) return otherwise;
  const std::optional<long long>& one = a->maxContacts;
  const std::optional<long long>& other = b->maxContacts;
  if (one && other) return std::min(*one, *other);
  return one ? *one : other.value_or(otherwise);
}

std::optional<DirectedFriction> directedFriction(const btPersistentManifold& manifold, const btManifoldPoint& point) {
  const LinkShape::Part* a = collisionAt(*manifold.getBody0(), point.m_index0);
  const LinkShape::Part* b = collisionAt(*manifold.getBody1(), point.m_index1);
  if (a == nullptr || b == nullptr) return std::nullopt;
  const description::Surface& one = *a->surface;
  const description::Surface& other = *b->surface;
  DirectedFriction friction{std::min(one.mu, other.mu), std::min(one.mu2, other.mu2), a->slip1 + b->slip1,
                            a->slip2 + b->slip2, btVector3(0, 0, 0)};
  if ((a->motion || b->motion) && takeAlong(friction, manifold, point, *a, *b)) return friction;
  if (friction.mu == friction.mu2 && friction.slip1 == 0 && friction.slip2 == 0) return std::nullopt;

  const bool hasOne = !one.fdir1.isZero(0);
  const bool hasOther = !other.fdir1.isZero(0);
  const btVector3& normal = point.m_normalWorldOnB;
  std::optional<btVector3> direction;
  if (hasOne && (!hasOther || one.mu2 <= other.mu2)) {
    direction = alongSurface(worldDirection(*manifold.getBody0(), *a), normal);
  } else if (hasOther) {
    direction = alongSurface(worldDirection(*manifold.getBody1(), *b), normal);
  }
  if (!direction) direction = alongSurface(btVector3(0, 0, 1), normal);
  friction.direction = direction ? *direction : *alongSurface(btVector3(1, 0, 0), normal);
  return friction;
}

}  // namespace pongsim::physics
