#include "physics/direct_solver.hh"

#include <cmath>
#include <cstddef>

namespace pongsim::physics {

namespace {

// an impulse beyond that comes from a matrix that could not be inverted [N s]
constexpr double kLargestImpulse = 1e6;

/// Takes impulses from their places to the rows, as many as there are.
/// @return Whether all of them are within reason.
bool takeSound(std::span<const double> x, std::span<const int> places, std::span<double> impulses) {
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    impulses[i] = x[static_cast<std::size_t>(places[i])];
    if (!(std::abs(impulses[i]) < kLargestImpulse)) return false;
  }
  return true;
}

}  // namespace

bool DirectSolver::solve(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds,
                         std::span<btTypedConstraint* const> joints, const btContactSolverInfo& info) {
  rows_.collect(bodies, manifolds, joints, info);
  placeRows();
  setProblem();
  if (!solveVelocities() || !solvePositions()) return false;
  rows_.apply(impulses_, impulsesApart_);
  return true;
}

void DirectSolver::placeRows() {
  const std::span<const GroupRows::Row> rows = rows_.rows();
  places_.resize(rows.size());
  const auto isEquation = [](const GroupRows::Row& row) {
    return row.normal < 0 && std::isinf(row.lowest) && std::isinf(row.highest);
  };
  int place = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (isEquation(rows[i])) places_[i] = place++;
  }
  equations_ = place;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!isEquation(rows[i])) places_[i] = place++;
  }
}

void DirectSolver::setProblem() {
  const std::size_t count = rows_.rows().size();
  A_.resize(count * count);
  rows_.couple(places_, A_.data());
  for (std::vector<double>* each : {&b_, &x_, &lowest_, &highest_, &impulses_}) each->resize(count);
  normalOf_.resize(count);
  bApart_.resize(static_cast<std::size_t>(rows_.unfrictionalRows()));
  penetrates_ = false;
  for (std::size_t i = 0; i < count; ++i) {
    const GroupRows::Row& row = rows_.rows()[i];
    const auto place = static_cast<std::size_t>(places_[i]);
    b_[place] = row.asked;
    lowest_[place] = row.lowest;
    highest_[place] = row.highest;
    normalOf_[place] = row.normal < 0 ? -1 : places_[static_cast<std::size_t>(row.normal)];
    if (place < bApart_.size()) bApart_[place] = row.askedApart;
    penetrates_ = penetrates_ || row.askedApart != 0;
  }
}

bool DirectSolver::solveVelocities() {
  const int count = static_cast<int>(b_.size());
  const bool isSolved = lcp_.solve({count, equations_, rows_.unfrictionalRows(), A_.data(), b_.data(), bApart_.data(),
                                    lowest_.data(), highest_.data(), normalOf_.data()},
                                   x_.data());
  return isSolved && takeSound(x_, places_, impulses_);
}

// what takes penetration back moves the bodies without giving them speed, and their joints with them
bool DirectSolver::solvePositions() {
  impulsesApart_.resize(penetrates_ ? bApart_.size() : 0);
  return !penetrates_ || (lcp_.solveSecond(x_.data()) && takeSound(x_, places_, impulsesApart_));
}

}  // namespace pongsim::physics
