#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <memory>

#include "description/geometry.hh"

namespace pongsim::benchmark {

/// @return A box, sphere, cylinder or plane as Bullet has it, with the margins that the engine gives them.
/// @throws std::invalid_argument for anything else.
std::unique_ptr<btCollisionShape> bareShape(const description::Geometry& geometry);

}  // namespace pongsim::benchmark
