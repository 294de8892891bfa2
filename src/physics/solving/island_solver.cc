#include "physics/solving/island_solver.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <cstddef>

namespace pongsim::physics {

namespace {

// of each contact point: one along the normal, two of friction
constexpr int kRowsPerContact = 3;

}  // namespace

void IslandSolver::solve(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds,
                         std::span<Joint* const> joints, double dt) {
  if (mayBeDirect(manifolds, joints) && direct_.solve(bodies, manifolds, joints, dt)) return;
  iterative_.solve(bodies, manifolds, joints, dt);
}

bool IslandSolver::mayBeDirect(std::span<btPersistentManifold* const> manifolds, std::span<Joint* const> joints) const {
  if (settings_.solver != Solver::kDirect) return false;
  int rows = 0;
  for (const btPersistentManifold* manifold : manifolds) rows += kRowsPerContact * manifold->getNumContacts();
  if (rows > settings_.mostDirectRows) return false;
  // two joints are no tree whose order matters: they have a body in common
  if (joints.size() > 2) return true;
  for (const Joint* joint : joints) rows += static_cast<int>(joint->rowCount());
  return rows <= settings_.mostDirectRows;
}

}  // namespace pongsim::physics
