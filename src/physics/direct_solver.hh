#pragma once

#include <vector>

#include "physics/contact_solver.hh"
#include "physics/lcp.hh"

namespace pongsim::physics {

/// Solves all rows of a group of bodies at once by Dantzig's direct method for mixed linear complementarity problems;
/// where that finds no sound solution, by iterations. Does what Bullet's `btMLCPSolver` does, without allocating in
/// each step, and without the variable that all threads share there.
class DirectSolver final : public ContactSolver {
 public:
  btConstraintSolverType getSolverType() const override { return BT_MLCP_SOLVER; }

 protected:
  btScalar solveGroupCacheFriendlyIterations(btCollisionObject** bodies, int bodyCount,
                                             btPersistentManifold** manifolds, int manifoldCount,
                                             btTypedConstraint** joints, int jointCount,
                                             const btContactSolverInfo& info, btIDebugDraw* debugDrawer) override;

 private:
  /// One end of a row as couplings take it: how the motion of the body there counts for the row (linear, angular), and
  /// how the body answers an impulse along it.
  struct End {
    double direction[6];
    double response[6];
    int row;
  };

  void collectRows();
  void buildMatrix(double softness);
  bool solve(int rows, bool isSameMatrix);
  bool solveVelocities();
  bool solvePositions();
  void collectEnds();
  void addCouplings(const End* ends, int count);

  btAlignedObjectArray<btSolverConstraint*> rows_;
  /// Of joints' rows that are two of Bullet's: their numbers in `rows_`, and the second ones.
  struct Tail {
    int row;
    btSolverConstraint* second;
  };
  std::vector<Tail> tails_;
  int jointRows_ = 0;
  /// Rows of joints and of contacts' normal directions: all but friction.
  int unfrictionalRows_ = 0;
  /// Those at the bodies that move, body after body, each body's in the rows' order; and where those of each body end.
  btAlignedObjectArray<End> ends_;
  btAlignedObjectArray<int> endsOfBody_;
  btAlignedObjectArray<btScalar> A_;
  btAlignedObjectArray<btScalar> b_;
  btAlignedObjectArray<btScalar> x_;
  btAlignedObjectArray<btScalar> lowest_;
  btAlignedObjectArray<btScalar> highest_;
  btAlignedObjectArray<int> normalOf_;
  Lcp lcp_;
};

}  // namespace pongsim::physics
