#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <span>
#include <vector>

#include "physics/joint.hh"
#include "physics/settings.hh"
#include "physics/solving/direct_solver.hh"
#include "physics/solving/gauss_seidel.hh"

namespace pongsim::physics {

/// Solves an island: directly, and so exactly, if it is a robot on its wheels or a tree of links; by Gauss-Seidel if it
/// is a heap, for which the cost of the direct method grows with the third power of its size. Through a link a hundred
/// times lighter than one that it is joined to, an impulse passes in more sweeps than there are, so that joints tear:
/// where such a link carries others, the island may be three times as large.
class IslandSolver {
 public:
  explicit IslandSolver(const Settings& settings) : settings_(settings), direct_(settings), iterative_(settings) {}

  /// Gives the bodies their velocities at the end of a step of `dt` [s], corrects penetration, and writes the impulses
  /// to the contact points and to measured joints.
  /// @param bodies Those of the island; all of them move.
  void solve(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds,
             std::span<Joint* const> joints, double dt);

 private:
  bool mayBeDirect(std::span<btPersistentManifold* const> manifolds, std::span<Joint* const> joints, int times) const;
  bool hasLightCarrier(std::span<Joint* const> joints);

  /// A body of a joint, and the inverse mass of the other one [1/kg].
  struct Neighbour {
    const btRigidBody* body;
    double inverseMass;
  };

  const Settings settings_;
  std::vector<Neighbour> neighbours_;
  DirectSolver direct_;
  GaussSeidel iterative_;
};

}  // namespace pongsim::physics
