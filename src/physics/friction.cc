#include "physics/friction.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cstddef>

#include "physics/convert.hh"
#include "physics/shape.hh"

namespace pongsim::physics {

namespace {

// below this sine of the angle to the normal, a direction is none of the surface
constexpr double kSmallestSine = 1e-3;

/// @return The collision that a point belongs to; null for a body that is not ours.
const LinkShape::Part* collisionAt(const btCollisionObject& object, int number) {
  const auto* shape = static_cast<const LinkShape*>(object.getUserPointer());
  return shape == nullptr ? nullptr : &shape->part(static_cast<std::size_t>(number));
}

btVector3 worldDirection(const btCollisionObject& object, const LinkShape::Part& part) {
  return object.getWorldTransform().getBasis() * toBullet(Vector3(part.q_BodyCollision * part.surface->fdir1));
}

/// @return The part of it in the tangent plane, as a unit vector; nothing where it lies along the normal.
std::optional<btVector3> alongSurface(const btVector3& direction, const btVector3& normal) {
  const btVector3 tangent = direction - normal * normal.dot(direction);
  const double length = tangent.length();
  if (length <= kSmallestSine * direction.length()) return std::nullopt;
  return tangent / length;
}

}  // namespace

std::optional<DirectedFriction> directedFriction(const btPersistentManifold& manifold, const btManifoldPoint& point) {
  const LinkShape::Part* a = collisionAt(*manifold.getBody0(), point.m_index0);
  const LinkShape::Part* b = collisionAt(*manifold.getBody1(), point.m_index1);
  if (a == nullptr || b == nullptr) return std::nullopt;
  const description::Surface& one = *a->surface;
  const description::Surface& other = *b->surface;
  DirectedFriction friction{std::min(one.mu, other.mu), std::min(one.mu2, other.mu2), one.slip1 + other.slip1,
                            one.slip2 + other.slip2, btVector3(0, 0, 0)};
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
