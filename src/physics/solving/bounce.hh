#pragma once

class btManifoldPoint;
class btPersistentManifold;
class btRigidBody;

namespace pongsim::physics {

struct PointSurface;

/// @return The coefficient of restitution at a point: none where the bodies meet more slowly than the surfaces'
/// threshold.
double restitutionAt(const btPersistentManifold& manifold, const btManifoldPoint& point, const PointSurface& surface);

/// Bullet lets two bodies that will meet in a step of `dt` [s] come to where they just touch, and takes what that costs
/// from the bounce. They bounce here with all of it, a little early, or not in this step at all.
/// @param a, b Null for a body that does not move.
/// @return What is to be added to the velocity that the point's row in the normal direction asks for [m/s].
double bounceChange(const btManifoldPoint& point, const btRigidBody* a, const btRigidBody* b, double dt);

}  // namespace pongsim::physics
