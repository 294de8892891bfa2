#pragma once

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>

#include <span>
#include <vector>

#include "physics/solving/group_rows.hh"
#include "physics/solving/joint_order.hh"
#include "physics/solving/reduced_lcp.hh"
#include "physics/solving/tree_lcp.hh"

namespace pongsim::physics {

/// Solves all rows of a group of bodies at once, as a mixed linear complementarity problem. Where links form trees or
/// chains, their joints are eliminated from the leaves to the root, at a cost that grows with their number.
class DirectSolver {
 public:
  /// @param mostRows Groups with more rows are solved only where these are equations of trees for the most part: with
  /// no more rows with bounds, and no more work for each row than there would be in a group of so many rows.
  explicit DirectSolver(int mostRows) : mostRows_(mostRows) {}

  /// Gives the bodies their velocities at the end of the step, takes penetration back, and writes the impulses to the
  /// points of contact and to joints that are measured.
  /// @return Whether it found a sound solution; else nothing is changed but friction's directions.
  bool solve(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds,
             std::span<btTypedConstraint* const> joints, const btContactSolverInfo& info);

 private:
  const JointOrder* orderOfTree(std::span<const JointBodies> joints);
  bool solveWhole();
  bool solveTree(const JointOrder& order);
  void placeRows();
  void setBounds(int skipped);
  bool solveSides(auto& lcp, const auto& problem);

  const int mostRows_;
  GroupRows rows_;
  /// Where each row stands in the problem: equations before what has bounds. Of a tree, first the numbers of rows with
  /// bounds, then where x has all of them.
  std::vector<int> places_;
  int equations_ = 0;
  /// Whether any is to be taken back without giving speed.
  bool penetrates_ = false;
  /// In the order of places; of a tree, those of rows with bounds.
  std::vector<double> lowest_;
  std::vector<double> highest_;
  std::vector<int> normalOf_;
  /// In the order of places; of a tree, as `BlockMatrix` has them.
  std::vector<double> x_;
  std::vector<double> xApart_;
  /// In the rows' order.
  std::vector<double> impulses_;
  std::vector<double> impulsesApart_;
  ReducedLcp lcp_;

  JointOrders orders_;
  std::vector<BlockMatrix::BoundedEnd> boundedEnds_;
  TreeLcp treeLcp_;
};

}  // namespace pongsim::physics
