#pragma once

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>

#include <span>
#include <vector>

#include "physics/group_rows.hh"
#include "physics/reduced_lcp.hh"

namespace pongsim::physics {

/// Solves all rows of a group of bodies at once, as a mixed linear complementarity problem.
class DirectSolver {
 public:
  /// Gives the bodies their velocities at the end of the step, takes penetration back, and writes the impulses to the
  /// points of contact and to joints that are measured.
  /// @return Whether it found a sound solution; else nothing is changed but friction's directions.
  bool solve(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds,
             std::span<btTypedConstraint* const> joints, const btContactSolverInfo& info);

 private:
  void placeRows();
  void setProblem();
  bool solveVelocities();
  bool solvePositions();

  GroupRows rows_;
  /// Where each row stands in the problem: equations before what has bounds.
  std::vector<int> places_;
  int equations_ = 0;
  std::vector<double> A_;
  std::vector<double> b_;
  /// What takes penetration back without giving speed.
  std::vector<double> bApart_;
  bool penetrates_ = false;
  std::vector<double> lowest_;
  std::vector<double> highest_;
  std::vector<int> normalOf_;
  /// In the order of places.
  std::vector<double> x_;
  /// In the rows' order.
  std::vector<double> impulses_;
  std::vector<double> impulsesApart_;
  ReducedLcp lcp_;
};

}  // namespace pongsim::physics
