#pragma once

struct btCollisionObjectWrapper;
class btCollisionShape;

namespace pongsim::description {
struct Surface;
}

namespace pongsim::physics {

/// @return The shape of the collision that is in touch, also where it is a part of a compound, or where a triangle of
/// it is; null where none of ours is.
const btCollisionShape* partOf(const btCollisionObjectWrapper* wrapper);

/// @return What the description says of such a shape.
const description::Surface& surfaceOf(const btCollisionShape& part);

/// Makes Bullet ask us how two surfaces act on each other. Bullet keeps this in one place for the whole process; any
/// number of engines may call it, at any time.
///
/// As Fortress's default engine DART does: the smaller of the two friction coefficients, the product of the two
/// coefficients of restitution. Friction that differs by direction is that of `directedFriction`.
void combineSurfacesAsFortress();

}  // namespace pongsim::physics
