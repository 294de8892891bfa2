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
  /// A row as its couplings take it: at each end, how the body's motion counts (linear, angular), and how the body
  /// answers an impulse.
  struct PackedRow {
    struct End {
      int body;
      double direction[6];
      double response[6];
    };
    End ends[2];
  };

  void collectRows();
  void buildMatrix(double softness);
  bool solve(int rows, bool isSameMatrix);
  bool solveVelocities();
  bool solvePositions();
  PackedRow packed(const btSolverConstraint& row) const;
  static double coupling(const PackedRow& a, const PackedRow& b);
  double coupling(int i, int j) const;

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
  btAlignedObjectArray<PackedRow> packedRows_;
  btAlignedObjectArray<btScalar> A_;
  btAlignedObjectArray<btScalar> b_;
  btAlignedObjectArray<btScalar> x_;
  btAlignedObjectArray<btScalar> lowest_;
  btAlignedObjectArray<btScalar> highest_;
  btAlignedObjectArray<int> normalOf_;
  Lcp lcp_;
};

}  // namespace pongsim::physics
