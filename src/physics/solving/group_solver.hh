#pragma once

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include "physics/solving/contact_solver.hh"
#include "physics/solving/direct_solver.hh"

namespace pongsim::physics {

/// Solves each group of bodies that hold or touch each other in the way that suits it: a robot on its wheels and a tree
/// of links directly, and so exactly; a heap, where the direct method's cost grows with the third power, by iterations.
class GroupSolver final : public btConstraintSolver {
 public:
  /// @param mostDirectRows Groups with more rows of joints and contacts than that are solved by iterations, but for
  /// trees of links.
  explicit GroupSolver(int mostDirectRows) : mostDirectRows_(mostDirectRows), direct_(mostDirectRows) {}

  btScalar solveGroup(btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds, int manifoldCount,
                      btTypedConstraint** joints, int jointCount, const btContactSolverInfo& info,
                      btIDebugDraw* debugDrawer, btDispatcher* dispatcher) override;
  void reset() override;
  btConstraintSolverType getSolverType() const override { return BT_SEQUENTIAL_IMPULSE_SOLVER; }

 private:
  const int mostDirectRows_;
  DirectSolver direct_;
  ContactSolver iterative_;
};

}  // namespace pongsim::physics
