#include "physics/shapes/shared_shapes.hh"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "base/hash.hh"
#include "physics/convert.hh"
#include "physics/shapes/cone_shape.hh"
#include "physics/shapes/ellipsoid_shape.hh"
#include "physics/shapes/margin.hh"

namespace pongsim::physics {

namespace {

struct MakeShape {
  using Result = std::shared_ptr<btCollisionShape>;

  Result operator()(const description::Box& box) const {
    auto shape = std::make_shared<btBoxShape>(toBullet(box.size / 2));
    shape->setMargin(marginFor(box.size.minCoeff() / 2));
    return shape;
  }
  Result operator()(const description::Sphere& sphere) const { return std::make_shared<btSphereShape>(sphere.radius); }
  Result operator()(const description::Cylinder& cylinder) const {
    const btVector3 halfLengths(cylinder.radius, cylinder.radius, cylinder.length / 2);
    auto shape = std::make_shared<btCylinderShapeZ>(halfLengths);
    shape->setMargin(marginFor(std::min(cylinder.radius, cylinder.length / 2)));
    return shape;
  }
  Result operator()(const description::Capsule& capsule) const {
    return std::make_shared<btCapsuleShapeZ>(capsule.radius, capsule.length);
  }
  Result operator()(const description::Ellipsoid& ellipsoid) const {
    return std::make_shared<EllipsoidShape>(toBullet(ellipsoid.radii));
  }
  Result operator()(const description::Cone& cone) const {
    return std::make_shared<ConeShape>(cone.radius, cone.length);
  }
  Result operator()(const description::Plane& plane) const {
    auto shape = std::make_shared<btStaticPlaneShape>(toBullet(plane.normal.normalized()), 0);
    shape->setMargin(0);
    return shape;
  }
  // shapes made of triangles are not shared between links
  Result operator()(const description::Mesh&) const { return nullptr; }
  Result operator()(const description::Heightmap&) const { return nullptr; }
  Result operator()(const description::Polyline&) const { return nullptr; }
  Result operator()(const description::Empty&) const { return nullptr; }
  Result operator()(const description::Image&) const { return nullptr; }
};

// hashes the values in which most of them differ
struct AddTo {
  void operator()(const description::Box& box) const { add(box.size); }
  void operator()(const description::Sphere& sphere) const { hash.add(sphere.radius); }
  void operator()(const description::Cylinder& cylinder) const {
    hash.add(cylinder.radius);
    hash.add(cylinder.length);
  }
  void operator()(const description::Capsule& capsule) const {
    hash.add(capsule.radius);
    hash.add(capsule.length);
  }
  void operator()(const description::Cone& cone) const {
    hash.add(cone.radius);
    hash.add(cone.length);
  }
  void operator()(const description::Ellipsoid& ellipsoid) const { add(ellipsoid.radii); }
  void operator()(const description::Plane& plane) const { add(plane.normal); }
  template <class Other>
  void operator()(const Other&) const {}

  void add(const Vector3& vector) const {
    for (const double value : vector) hash.add(value);
  }

  base::Hash& hash;
};

std::uint64_t hashOf(const description::Surface& surface) {
  base::Hash hash;
  for (const double value : {surface.mu, surface.mu2, surface.slip1, surface.slip2, surface.restitution,
                             surface.torsion.coefficient, surface.torsion.patchRadius, surface.torsion.surfaceRadius}) {
    hash.add(value);
  }
  hash.add(std::uint64_t{surface.collideBitmask});
  return hash.value();
}

std::uint64_t hashOf(const description::Geometry& geometry, int collision) {
  base::Hash hash;
  hash.add(static_cast<std::uint64_t>(geometry.index()));
  hash.add(static_cast<std::uint64_t>(collision));
  std::visit(AddTo{hash}, geometry);
  return hash.value();
}

/// Drops unused entries, if there are many. The table may then double before the next time, which keeps the cost per
/// entry low.
template <class Table>
void prune(Table& table, std::size_t& most) {
  if (table.size() < most) return;
  std::erase_if(table, [](const auto& entry) { return entry.second.expired(); });
  most = std::max(most, 2 * table.size());
}

}  // namespace

std::shared_ptr<const description::Surface> SharedShapes::surface(const description::Surface& surface) {
  const std::uint64_t hash = hashOf(surface);
  const auto [begin, end] = surfaces_.equal_range(hash);
  for (auto entry = begin; entry != end; ++entry) {
    if (auto known = entry->second.lock(); known && *known == surface) return known;
  }
  prune(surfaces_, mostSurfaces_);
  auto made = std::make_shared<const description::Surface>(surface);
  surfaces_.emplace(hash, made);
  return made;
}

std::shared_ptr<btCollisionShape> SharedShapes::shape(const description::Geometry& geometry,
                                                      const description::Surface& surface, int collision) {
  const std::uint64_t hash = hashOf(geometry, collision);
  const auto [begin, end] = shapes_.equal_range(hash);
  for (auto entry = begin; entry != end; ++entry) {
    const ShapeEntry& known = entry->second;
    if (known.surface != &surface || known.collision != collision || known.geometry != geometry) continue;
    if (auto shape = known.shape.lock()) return shape;
  }
  auto made = std::visit(MakeShape(), geometry);
  if (made == nullptr) return made;
  prune(shapes_, mostShapes_);
  made->setUserPointer(const_cast<description::Surface*>(&surface));
  made->setUserIndex(collision);
  made->setUserIndex2(0);
  shapes_.emplace(hash, ShapeEntry{geometry, &surface, collision, made});
  return made;
}

}  // namespace pongsim::physics
