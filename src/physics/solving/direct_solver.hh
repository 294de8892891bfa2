#pragma once

#include <span>
#include <vector>

#include "physics/lcp/joint_order.hh"
#include "physics/lcp/reduced_lcp.hh"
#include "physics/lcp/tree_lcp.hh"
#include "physics/settings.hh"
#include "physics/solving/island_rows.hh"

namespace pongsim::physics {

/// Solves all rows of an island at once, as a mixed linear complementarity problem. Joints of trees and chains of links
/// are eliminated from the leaves to the root, at a cost that is linear in their number.
class DirectSolver {
 public:
  /// Islands with more rows than `settings.mostDirectRows` are solved only if most of them are equations of trees: with
  /// no more bounded rows than that, and no more work per row than in an island of that many rows.
  explicit DirectSolver(const Settings& settings) : mostOfSettings_(settings.mostDirectRows), rows_(settings) {}

  /// Gives the bodies their velocities at the end of the step of `dt` [s], corrects penetration, and writes the
  /// impulses to the contact points and to measured joints.
  /// @param times How many times as many rows it may have as the settings say.
  /// @return False if there is no reasonable solution; then only friction directions have changed.
  bool solve(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds,
             std::span<Joint* const> joints, double dt, int times = 1);

 private:
  const JointOrder* orderOfTree(std::span<const JointBodies> joints);
  bool solveWhole();
  bool solveTree(const JointOrder& order);
  void placeRows();
  void setBounds(int skipped);
  bool solveSides(auto& lcp, const auto& problem);

  const int mostOfSettings_;
  /// Of this island.
  int mostRows_ = 0;
  IslandRows rows_;
  /// The place of each row in the problem: equations before bounded rows. Of a tree, first the numbers of bounded rows,
  /// then the place of all in x.
  std::vector<int> places_;
  int equations_ = 0;
  /// Whether any row has a push right-hand side.
  bool hasPenetration_ = false;
  /// In the order of places; of a tree, those of bounded rows.
  std::vector<double> lowest_;
  std::vector<double> highest_;
  std::vector<int> normalOf_;
  /// In the order of places; of a tree, as `BlockMatrix` has them.
  std::vector<double> x_;
  std::vector<double> xPush_;
  /// In the rows' order.
  std::vector<double> impulses_;
  std::vector<double> pushImpulses_;
  ReducedLcp lcp_;

  JointOrders orders_;
  std::vector<BlockMatrix::BoundedEnd> boundedEnds_;
  TreeLcp treeLcp_;
};

}  // namespace pongsim::physics
