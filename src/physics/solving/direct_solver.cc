#include "physics/solving/direct_solver.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pongsim::physics {

namespace {

// a larger impulse comes from a matrix that is not invertible in floating-point numbers [N s]
constexpr double kLargestImpulse = 1e6;

/// Copies impulses from their places to the rows' order.
/// @return Whether all of them are reasonable.
bool takeIfReasonable(std::span<const double> x, std::span<const int> places, std::span<double> impulses) {
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    impulses[i] = x[static_cast<std::size_t>(places[i])];
    if (!(std::abs(impulses[i]) < kLargestImpulse)) return false;
  }
  return true;
}

}  // namespace

bool DirectSolver::solve(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds,
                         std::span<Joint* const> joints, double dt, int times) {
  mostRows_ = times * mostOfSettings_;
  const std::span<const JointBodies> jointBodies = rows_.begin(bodies, joints, dt);
  rows_.collect(manifolds, joints, treeOf(jointBodies));
  if (rows_.rows().size() > static_cast<std::size_t>(mostRows_) || !rows_.articulate() || !solveRows()) return false;
  rows_.apply(impulses_, pushImpulses_);
  return true;
}

/// @return Null where all joints that hang together act on one body: their few rows are solved like all others.
const JointTree* DirectSolver::treeOf(std::span<const JointBodies> joints) {
  if (haveOneHub(joints)) return nullptr;
  const JointTree& tree = trees_.find(joints);
  return tree.isDeep() ? &tree : nullptr;
}

bool DirectSolver::solveRows() {
  const std::size_t count = rows_.rows().size();
  hasPenetration_ = std::ranges::any_of(rows_.rows(), [](const IslandRows::Row& row) { return row.pushRhs != 0; });
  impulses_.resize(count);
  pushImpulses_.resize(hasPenetration_ ? static_cast<std::size_t>(rows_.unfrictionalRows()) : 0);
  if (count == 0) return true;
  placeRows();
  const UpperRows A = lcp_.begin(static_cast<int>(count));
  rows_.assemble(places_, A);
  for (std::size_t i = 0; i < count; ++i) {
    double* const row = A.row(static_cast<std::size_t>(places_[i]));
    row[count] = rows_.rows()[i].rhs;
    row[count + 1] = rows_.rows()[i].pushRhs;
  }
  setBounds();
  return solveSides();
}

void DirectSolver::placeRows() {
  const std::span<const IslandRows::Row> rows = rows_.rows();
  places_.resize(rows.size());
  int place = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].isEquation) places_[i] = place++;
  }
  equations_ = place;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].isEquation) places_[i] = place++;
  }
}

void DirectSolver::setBounds() {
  const std::span<const IslandRows::Row> rows = rows_.rows();
  for (std::vector<double>* each : {&lowest_, &highest_, &x_}) each->resize(rows.size());
  normalOf_.resize(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto place = static_cast<std::size_t>(places_[i]);
    lowest_[place] = rows[i].lowest;
    highest_[place] = rows[i].highest;
    const int normal = rows[i].normal;
    normalOf_[place] = normal < 0 ? -1 : places_[static_cast<std::size_t>(normal)];
  }
}

/// Solves for the impulses and, with penetration, for the push impulses, which also keep the joints together.
bool DirectSolver::solveSides() {
  const ReducedLcp::Problem problem{equations_, rows_.unfrictionalRows(), lowest_.data(), highest_.data(),
                                    normalOf_.data()};
  if (!lcp_.solve(problem, x_) || !takeIfReasonable(x_, places_, impulses_)) return false;
  return !hasPenetration_ || (lcp_.solveSecond(x_) && takeIfReasonable(x_, places_, pushImpulses_));
}

}  // namespace pongsim::physics
