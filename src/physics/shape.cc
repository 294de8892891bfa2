#include "physics/shape.hh"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btEmptyShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "physics/convert.hh"
#include "physics/ellipsoid_shape.hh"
#include "physics/margin.hh"
#include "physics/mesh_shape.hh"

namespace pongsim::physics {

namespace {

struct MakeShape {
  using Result = std::unique_ptr<btCollisionShape>;

  Result operator()(const description::Box& box) const {
    auto shape = std::make_unique<btBoxShape>(toBullet(box.size / 2));
    shape->setMargin(marginFor(box.size.minCoeff() / 2));
    return shape;
  }
  Result operator()(const description::Sphere& sphere) const { return std::make_unique<btSphereShape>(sphere.radius); }
  Result operator()(const description::Cylinder& cylinder) const {
    const btVector3 halfLengths(cylinder.radius, cylinder.radius, cylinder.length / 2);
    auto shape = std::make_unique<btCylinderShapeZ>(halfLengths);
    shape->setMargin(marginFor(std::min(cylinder.radius, cylinder.length / 2)));
    return shape;
  }
  Result operator()(const description::Capsule& capsule) const {
    return std::make_unique<btCapsuleShapeZ>(capsule.radius, capsule.length);
  }
  Result operator()(const description::Ellipsoid& ellipsoid) const {
    return std::make_unique<EllipsoidShape>(toBullet(ellipsoid.radii));
  }
  Result operator()(const description::Plane& plane) const {
    auto shape = std::make_unique<btStaticPlaneShape>(toBullet(plane.normal.normalized()), 0);
    shape->setMargin(0);
    return shape;
  }
  // of a body that moves; for others see below
  Result operator()(const description::Mesh& mesh) const {
    return mesh.triangles != nullptr ? makeHull(*mesh.triangles, mesh.scale) : nullptr;
  }
  Result operator()(const description::Heightmap& map) const {
    return map.triangles != nullptr ? makeHull(*map.triangles, {1, 1, 1}) : nullptr;
  }
  Result operator()(const description::Polyline& polyline) const {
    return polyline.triangles != nullptr ? makeHull(*polyline.triangles, {1, 1, 1}) : nullptr;
  }
  Result operator()(const description::Empty&) const { return nullptr; }
  Result operator()(const description::Image&) const { return nullptr; }
};

/// @return The triangles that a shape is made of, and their scale; null where it is not.
std::pair<const description::TriangleMesh*, Vector3> trianglesOf(const description::Geometry& geometry) {
  if (const auto* mesh = std::get_if<description::Mesh>(&geometry)) return {mesh->triangles.get(), mesh->scale};
  if (const auto* map = std::get_if<description::Heightmap>(&geometry)) return {map->triangles.get(), {1, 1, 1}};
  if (const auto* line = std::get_if<description::Polyline>(&geometry)) return {line->triangles.get(), {1, 1, 1}};
  return {nullptr, {1, 1, 1}};
}

}  // namespace

LinkShape::LinkShape(const description::Link& link, const Pose& X_BodyLink, bool moves) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < link.collisions.size(); ++i) {
    const description::Collision& collision = link.collisions[i];
    Pose X_BodyPart = X_BodyLink * collision.X_LinkCollision;
    collisions_.push_back({&collision.surface, X_BodyPart.rotation, collision.surface.slip1, collision.surface.slip2});
    btCollisionShape* shape = nullptr;
    const auto [triangles, scale] = trianglesOf(collision.geometry);
    if (triangles != nullptr && !moves) {
      surfaces_.push_back(std::make_unique<TriangleSurface>(*triangles, scale, X_BodyPart));
      shape = surfaces_.back()->shape();
      X_BodyPart = Pose();
    } else if (auto made = std::visit(MakeShape(), collision.geometry)) {
      shape = made.get();
      owned_.push_back(std::move(made));
    }
    if (shape == nullptr) continue;
    shape->setUserPointer(const_cast<description::Surface*>(&collision.surface));
    parts_.push_back(shape);
    shape->setUserIndex(static_cast<int>(i));
    poses.push_back(X_BodyPart);
  }

  if (parts_.empty()) {
    holder_ = std::make_unique<btEmptyShape>();
    root_ = holder_.get();
    return;
  }

  // one part that lies as the body does needs no compound
  const bool inPlace = poses[0].position.isZero(0) && poses[0].rotation.vec().isZero(0);
  if (parts_.size() == 1 && inPlace) {
    root_ = parts_[0];
    return;
  }
  auto compound = std::make_unique<btCompoundShape>(true, static_cast<int>(parts_.size()));
  for (std::size_t i = 0; i < parts_.size(); ++i) compound->addChildShape(toBullet(poses[i]), parts_[i]);
  holder_ = std::move(compound);
  root_ = holder_.get();
}

void LinkShape::transfer(StateArchive& archive) {
  for (Part& part : collisions_) {
    archive(part.slip1);
    archive(part.slip2);
    archive(part.motion);
  }
}

}  // namespace pongsim::physics
