#include "benchmark/bare_shape.hh"

#include <btBulletCollisionCommon.h>

#include <stdexcept>
#include <variant>

#include "physics/convert.hh"

namespace pongsim::benchmark {

using physics::toBullet;

std::unique_ptr<btCollisionShape> bareShape(const description::Geometry& geometry) {
  std::unique_ptr<btCollisionShape> shape;
  if (const auto* box = std::get_if<description::Box>(&geometry)) {
    shape = std::make_unique<btBoxShape>(toBullet(Vector3(box->size / 2)));
  } else if (const auto* sphere = std::get_if<description::Sphere>(&geometry)) {
    shape = std::make_unique<btSphereShape>(sphere->radius);
  } else if (const auto* cylinder = std::get_if<description::Cylinder>(&geometry)) {
    shape = std::make_unique<btCylinderShapeZ>(btVector3(cylinder->radius, cylinder->radius, cylinder->length / 2));
    shape->setMargin(0.001);
  } else if (const auto* plane = std::get_if<description::Plane>(&geometry)) {
    shape = std::make_unique<btStaticPlaneShape>(toBullet(plane->normal), 0);
    shape->setMargin(0);
  } else {
    throw std::invalid_argument("no such shape here");
  }
  return shape;
}

}  // namespace pongsim::benchmark
