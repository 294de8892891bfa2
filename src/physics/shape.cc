#include "physics/shape.hh"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btEmptyShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <algorithm>
#include <variant>

#include "physics/convert.hh"

namespace pongsim::physics {

namespace {

// Bullet rounds edges by the margin. It stays far below the size of the part, and below a millimetre, so that a wheel
// stands on its whole width.
double marginFor(double smallestHalfLength) { return std::min(0.001, 0.01 * smallestHalfLength); }

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
  Result operator()(const description::Plane& plane) const {
    auto shape = std::make_unique<btStaticPlaneShape>(toBullet(plane.normal.normalized()), 0);
    shape->setMargin(0);
    return shape;
  }
  Result operator()(const description::Empty&) const { return nullptr; }
  Result operator()(const description::OtherGeometry&) const { return nullptr; }
};

}  // namespace

LinkShape::LinkShape(const description::Link& link, const Pose& X_BodyLink) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < link.collisions.size(); ++i) {
    const description::Collision& collision = link.collisions[i];
    auto shape = std::visit(MakeShape(), collision.geometry);
    if (!shape) continue;
    shape->setUserPointer(const_cast<description::Surface*>(&collision.surface));
    parts_.push_back(std::move(shape));
    collisionOfPart_.push_back(i);
    poses.push_back(X_BodyLink * collision.X_LinkCollision);
  }

  if (parts_.empty()) {
    holder_ = std::make_unique<btEmptyShape>();
    root_ = holder_.get();
    return;
  }

  // one part that lies as the body does needs no compound
  const bool inPlace = poses[0].position.isZero(0) && poses[0].rotation.vec().isZero(0);
  if (parts_.size() == 1 && inPlace) {
    root_ = parts_[0].get();
    return;
  }
  auto compound = std::make_unique<btCompoundShape>(true, static_cast<int>(parts_.size()));
  for (std::size_t i = 0; i < parts_.size(); ++i) compound->addChildShape(toBullet(poses[i]), parts_[i].get());
  holder_ = std::move(compound);
  root_ = holder_.get();
}

}  // namespace pongsim::physics
