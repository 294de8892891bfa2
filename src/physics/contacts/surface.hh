#pragma once

struct btCollisionObjectWrapper;
class btCollisionShape;

namespace pongsim::description {
struct Surface;
}

namespace pongsim::physics {

/// @return The shape of the colliding collision, also if it is part of a compound or if one of its triangles collides;
/// null if it is not one of ours.
const btCollisionShape* partOf(const btCollisionObjectWrapper* wrapper);

/// @return The surface description of such a shape.
const description::Surface& surfaceOf(const btCollisionShape& part);

/// Installs our rule for combining two surfaces in Bullet. Bullet has one such hook for the whole process; any number
/// of engines may call this, at any time.
///
/// Follows DART, Fortress's default engine: the smaller friction coefficient, and the product of the coefficients of
/// restitution. For friction that depends on the direction see `directedFriction`.
void combineSurfacesAsFortress();

}  // namespace pongsim::physics
