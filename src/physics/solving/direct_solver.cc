#include "physics/solving/direct_solver.hh"

#include <algorithm>
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
  const std::span<const JointBodies> jointBodies = rows_.begin(bodies, joints, info);
  const JointOrder* const order = orderOfTree(jointBodies);
  rows_.collect(manifolds, joints, order != nullptr);
  impulses_.resize(rows_.rows().size());
  penetrates_ = std::ranges::any_of(rows_.rows(), [](const GroupRows::Row& row) { return row.askedApart != 0; });
  if (order != nullptr ? !solveTree(*order) : !solveWhole()) return false;
  rows_.apply(impulses_, impulsesApart_);
  return true;
}

/// @return The order in which joints are eliminated; null where none is better than another.
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
  rows_.couple(places_, A);
  for (std::size_t i = 0; i < count; ++i) {
    double* const row = A.row(static_cast<std::size_t>(places_[i]));
    row[count] = rows_.rows()[i].asked;
    row[count + 1] = rows_.rows()[i].askedApart;
  }
  setBounds(0);
  x_.resize(count);
  return solveSides(lcp_, ReducedLcp::Problem{equations_, rows_.unfrictionalRows(), lowest_.data(), highest_.data(),
                                              normalOf_.data()});
}

void DirectSolver::placeRows() {
  const std::span<const GroupRows::Row> rows = rows_.rows();
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

/// Sets the bounds of rows but for the first `skipped` places.
void DirectSolver::setBounds(int skipped) {
  const std::span<const GroupRows::Row> rows = rows_.rows();
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
  const std::span<const GroupRows::Row> rows = rows_.rows();
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
  rows_.couple(order, places_, A);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int place = rows[i].isEquation ? order.placeOf(rows[i].joint) : A.boundedPlace();
    const int number = rows[i].isEquation ? rows[i].lane : places_[i];
    double* const sides = A.sides(place, number);
    sides[0] = rows[i].asked;
    sides[1] = rows[i].askedApart;
    places_[i] = A.indexOf(place, number);
  }
  x_.resize(A.size());
  if (!solveSides(treeLcp_, TreeLcp::Bounds{rows_.unfrictionalRows() - equations_, lowest_.data(), highest_.data(),
                                            normalOf_.data()})) {
    return false;
  }
  rows_.applyEquations(order, A, x_.data(), penetrates_ ? xApart_.data() : nullptr);
  return true;
}

/// Finds the impulses. What takes penetration back moves the bodies without giving them speed, and their joints with
/// them.
bool DirectSolver::solveSides(auto& lcp, const auto& problem) {
  impulsesApart_.resize(penetrates_ ? static_cast<std::size_t>(rows_.unfrictionalRows()) : 0);
  if (!lcp.solve(problem, x_) || !takeSound(x_, places_, impulses_)) return false;
  if (!penetrates_) return true;
  xApart_.resize(x_.size());
  return lcp.solveSecond(xApart_) && takeSound(xApart_, places_, impulsesApart_);
}

}  // namespace pongsim::physics
