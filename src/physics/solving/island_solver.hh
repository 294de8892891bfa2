#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <span>

#include "physics/joint.hh"
#include "physics/settings.hh"
#include "physics/solving/direct_solver.hh"
#include "physics/solving/gauss_seidel.hh"

namespace pongsim::physics {

/// Solves an island: directly, and so exactly, if it is a robot on its wheels or a tree of links; by Gauss-Seidel if it
/// is a heap, for which the cost of the direct method grows with the third power of its size.
class IslandSolver {
 public:
  explicit IslandSolver(const Settings& settings) : settings_(settings), direct_(settings), iterative_(settings) {}

  /// Gives the bodies their velocities at the end of a step of `dt` [s], corrects penetration, and writes the impulses
  /// to the contact points and to measured joints.
  /// @param bodies Those of the island; all of them move.
  void solve(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds,
             std::span<Joint* const> joints, double dt);

 private:
  bool mayBeDirect(std::span<btPersistentManifold* const> manifolds, std::span<Joint* const> joints) const;

  const Settings settings_;
  DirectSolver direct_;
  GaussSeidel iterative_;
};

}  // namespace pongsim::physics
