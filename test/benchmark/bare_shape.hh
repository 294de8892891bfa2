#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <memory>

#include "description/geometry.hh"

namespace pongsim::benchmark {

/// @return Bullet's shape for a box, sphere, cylinder or plane, with the margins of our engine.
/// @throws std::invalid_argument for anything else.
std::unique_ptr<btCollisionShape> bareShape(const description::Geometry& geometry);

}  // namespace pongsim::benchmark
