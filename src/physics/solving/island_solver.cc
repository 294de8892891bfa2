#include "physics/solving/island_solver.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace pongsim::physics {

namespace {

// of each contact point: one along the normal, two of friction
constexpr int kRowsPerContact = 3;

// a link is light beside one that it is joined to if its mass is a smaller share
constexpr double kLightShare = 0.01;

// how many times as many rows are solved directly where a light link carries others
constexpr int kTimesForLight = 3;

}  // namespace

void IslandSolver::solve(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds,
                         std::span<Joint* const> joints, double dt) {
  if (mayBeDirect(manifolds, joints, 1) && direct_.solve(bodies, manifolds, joints, dt)) return;
  if (mayBeDirect(manifolds, joints, kTimesForLight) && hasLightCarrier(joints) &&
      direct_.solve(bodies, manifolds, joints, dt, kTimesForLight)) {
    return;
  }
  iterative_.solve(bodies, manifolds, joints, dt);
}

bool IslandSolver::mayBeDirect(std::span<btPersistentManifold* const> manifolds, std::span<Joint* const> joints,
                               int times) const {
  if (settings_.solver != Solver::kDirect) return false;
  const int most = times * settings_.mostDirectRows;
  int rows = 0;
  for (const btPersistentManifold* manifold : manifolds) rows += kRowsPerContact * manifold->getNumContacts();
  if (rows > most) return false;
  // two joints are no tree whose order matters: they have a body in common
  if (joints.size() > 2) return true;
  for (const Joint* joint : joints) rows += static_cast<int>(joint->rowCount());
  return rows <= most;
}

/// @return Whether a link carries others by joints though it is far lighter than one of them; the world is heavier than
/// any.
bool IslandSolver::hasLightCarrier(std::span<Joint* const> joints) {
  neighbours_.clear();
  for (const Joint* joint : joints) {
    neighbours_.push_back({&joint->parent(), joint->child().getInvMass()});
    neighbours_.push_back({&joint->child(), joint->parent().getInvMass()});
  }
  // the order of addresses has no influence on the result
  std::ranges::sort(neighbours_, std::less<>(), &Neighbour::body);
  for (std::size_t first = 0, end = 0; first < neighbours_.size(); first = end) {
    const btRigidBody* body = neighbours_[first].body;
    bool hasHeavy = false;
    for (end = first; end < neighbours_.size() && neighbours_[end].body == body; ++end) {
      hasHeavy = hasHeavy || neighbours_[end].inverseMass < kLightShare * body->getInvMass();
    }
    if (hasHeavy && end - first >= 2) return true;
  }
  return false;
}

}  // namespace pongsim::physics
