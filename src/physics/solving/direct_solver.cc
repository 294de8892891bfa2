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
  const JointOrder* const order = orderOfTree(jointBodies);
  rows_.collect(manifolds, joints, order != nullptr);
  impulses_.resize(rows_.rows().size());
  hasPenetration_ = std::ranges::any_of(rows_.rows(), [](const IslandRows::Row& row) { return row.pushRhs != 0; });
  if (order != nullptr ? !solveTree(*order) : !solveWhole()) return false;
  rows_.apply(impulses_, pushImpulses_);
  return true;
}

/// @return The order in which joints are eliminated; null if none is better than another.
const JointOrder* DirectSolver::orderOfTree(std::span<const JointBodies> joints) {
  if (haveOneHub(joints)) return nullptr;
  const JointOrder& order = orders_.find(joints);
  return order.isDeep() ? &order : nullptr;
}

bool DirectSolver::solveWhole() {
  const std::size_t count = rows_.rows().size();
  if (count > static_cast<std::size_t>(mostRows_)) return false;
  placeRows();
  const UpperRows A = lcp_.begin(static_cast<int>(count));
  rows_.assemble(places_, A);
  for (std::size_t i = 0; i < count; ++i) {
    double* const row = A.row(static_cast<std::size_t>(places_[i]));
    row[count] = rows_.rows()[i].rhs;
    row[count + 1] = rows_.rows()[i].pushRhs;
  }
  setBounds(0);
  x_.resize(count);
  return solveSides(lcp_, ReducedLcp::Problem{equations_, rows_.unfrictionalRows(), lowest_.data(), highest_.data(),
                                              normalOf_.data()});
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

/// Sets the bounds of all rows but those at the first `skipped` places.
void DirectSolver::setBounds(int skipped) {
  const std::span<const IslandRows::Row> rows = rows_.rows();
  const std::size_t count = rows.size() - static_cast<std::size_t>(skipped);
  lowest_.resize(count);
  highest_.resize(count);
  normalOf_.resize(count);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (places_[i] < skipped) continue;
    const auto place = static_cast<std::size_t>(places_[i] - skipped);
    lowest_[place] = rows[i].lowest;
    highest_[place] = rows[i].highest;
    const int normal = rows[i].normal;
    normalOf_[place] = normal < 0 ? -1 : places_[static_cast<std::size_t>(normal)] - skipped;
  }
}

bool DirectSolver::solveTree(const JointOrder& order) {
  const std::span<const IslandRows::Row> rows = rows_.rows();
  placeRows();
  const int bounded = static_cast<int>(rows.size()) - equations_;
  if (bounded > mostRows_) return false;
  if (bounded > 0) setBounds(equations_);
  for (int& number : places_) number -= equations_;
  BlockMatrix& A = treeLcp_.matrix();
  rows_.listBoundedEnds(places_, boundedEnds_);
  if (!A.begin(order, rows_.equations(), bounded, boundedEnds_)) return false;
  const double most = mostRows_;
  if (A.work() > static_cast<double>(rows.size()) * most * most / 6) return false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].isEquation) places_[i] = A.boundedNumber(places_[i]);
  }
  rows_.assemble(order, places_, A);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int place = rows[i].isEquation ? order.placeOf(rows[i].joint) : A.boundedPlace();
    const int number = rows[i].isEquation ? rows[i].rowInJoint : places_[i];
    double* const sides = A.sides(place, number);
    sides[0] = rows[i].rhs;
    sides[1] = rows[i].pushRhs;
    places_[i] = A.indexOf(place, number);
  }
  x_.resize(A.size());
  if (!solveSides(treeLcp_, TreeLcp::Bounds{rows_.unfrictionalRows() - equations_, lowest_.data(), highest_.data(),
                                            normalOf_.data()})) {
    return false;
  }
  rows_.applyEquations(order, A, x_.data(), hasPenetration_ ? xPush_.data() : nullptr);
  return true;
}

/// Solves for the impulses and, with penetration, for the push impulses, which also keep the joints together.
bool DirectSolver::solveSides(auto& lcp, const auto& problem) {
  pushImpulses_.resize(hasPenetration_ ? static_cast<std::size_t>(rows_.unfrictionalRows()) : 0);
  if (!lcp.solve(problem, x_) || !takeIfReasonable(x_, places_, impulses_)) return false;
  if (!hasPenetration_) return true;
  xPush_.resize(x_.size());
  return lcp.solveSecond(xPush_) && takeIfReasonable(xPush_, places_, pushImpulses_);
}

}  // namespace pongsim::physics
