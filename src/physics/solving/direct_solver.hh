#pragma once

#include <span>
#include <vector>

#include "physics/lcp/reduced_lcp.hh"
#include "physics/settings.hh"
#include "physics/solving/island_rows.hh"
#include "physics/solving/joint_tree.hh"

namespace pongsim::physics {

/// Solves all rows of an island at once, as a mixed linear complementarity problem. Links that joints hold together as
/// trees and chains move as these allow (`Articulation`), at a cost that is linear in their number.
class DirectSolver {
 public:
  /// Islands with more rows than `settings.mostDirectRows`, beside those of joints in trees, are not solved.
  explicit DirectSolver(const Settings& settings) : mostOfSettings_(settings.mostDirectRows), rows_(settings) {}

  /// Gives the bodies their velocities at the end of the step of `dt` [s], corrects penetration, and writes the
  /// impulses to the contact points and to measured joints.
  /// @param times How many times as many rows it may have as the settings say.
  /// @return False if there is no reasonable solution; then only friction directions have changed.
  bool solve(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds,
             std::span<Joint* const> joints, double dt, int times = 1);

 private:
  const JointTree* treeOf(std::span<const JointBodies> joints);
  bool solveRows();
  void placeRows();
  void setBounds();
  bool solveSides();

  const int mostOfSettings_;
  /// Of this island.
  int mostRows_ = 0;
  IslandRows rows_;
  /// The place of each row in the problem: equations before bounded rows.
  std::vector<int> places_;
  int equations_ = 0;
  /// Whether any row has a push right-hand side.
  bool hasPenetration_ = false;
  /// In the order of places.
  std::vector<double> lowest_;
  std::vector<double> highest_;
  std::vector<int> normalOf_;
  std::vector<double> x_;
  /// In the rows' order.
  std::vector<double> impulses_;
  std::vector<double> pushImpulses_;
  ReducedLcp lcp_;

  JointTrees trees_;
};

}  // namespace pongsim::physics
