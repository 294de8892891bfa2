#pragma once

class btManifoldPoint;
class btPersistentManifold;
class btRigidBody;

namespace pongsim::physics {

struct PointSurface;

/// @return The coefficient of restitution at a point: 0 if the bodies meet more slowly than the surfaces' threshold.
double restitutionAt(const btPersistentManifold& manifold, const btManifoldPoint& point, const PointSurface& surface);

/// A contact row lets bodies close a gap d > 0 within the step: its bias is e v - d/dt, where v is the speed of
/// approach and e the restitution, so a bounce would lose d/dt. This corrects the bias: to e v, a full bounce a little
/// early, if the bodies meet in this step (v > d/dt), and to -d/dt, no bounce, if they do not.
/// @param dt Length of the step [s].
/// @return The change of the bias [m/s].
double bounceChange(const btManifoldPoint& point, const btRigidBody& a, const btRigidBody& b, double dt);

}  // namespace pongsim::physics
