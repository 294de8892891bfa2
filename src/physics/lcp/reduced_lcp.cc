#include "physics/lcp/reduced_lcp.hh"

#include <cassert>

namespace pongsim::physics {

UpperRows ReducedLcp::begin(int rows) {
  rows_ = static_cast<std::size_t>(rows);
  width_ = widthFor(rows_ + 2);
  U_.assign(rows_ * width_, 0.0);
  return upper();
}

bool ReducedLcp::solve(const Problem& problem, std::span<double> x) {
  assert(0 <= problem.equations && problem.equations <= problem.unfrictionalRows);
  assert(static_cast<std::size_t>(problem.unfrictionalRows) <= rows_ && x.size() >= rows_);
  problem_ = problem;
  equations_ = static_cast<std::size_t>(problem.equations);
  unfrictional_ = static_cast<std::size_t>(problem.unfrictionalRows);
  if (!reduce()) return false;
  if (rows_ > equations_ && !lcp_.solve(rest(rows_, b_.data()), x.data() + equations_)) return false;
  substitute(upper(), inverseD_.data(), 0, equations_, rows_, rows_, x.data());
  return true;
}

bool ReducedLcp::solveSecond(std::span<double> x) {
  const bool isSolved =
      unfrictional_ == equations_ || lcp_.solveWithSameMatrix(rest(unfrictional_, b2_.data()), x.data() + equations_);
  if (!isSolved) return false;
  substitute(upper(), inverseD_.data(), 0, equations_, unfrictional_, rows_ + 1, x.data());
  return true;
}

/// The rows behind the equations and before `end`.
Lcp::Problem ReducedLcp::rest(std::size_t end, const double* b) const {
  return {static_cast<int>(end - equations_),
          A_.data(),
          static_cast<int>(rows_ - equations_),
          b,
          problem_.lowest + equations_,
          problem_.highest + equations_,
          normalOf_.data()};
}

/// @return False where A is not positive definite.
bool ReducedLcp::reduce() {
  inverseD_.resize(equations_);
  if (!eliminate(upper(), equations_, inverseD_.data())) return false;
  const std::size_t count = rows_ - equations_;
  A_.resize(count * count);
  b_.resize(count);
  b2_.resize(count);
  normalOf_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* const from = upper().row(equations_ + i);
    for (std::size_t j = i; j < count; ++j) A_[i * count + j] = A_[j * count + i] = from[equations_ + j];
    b_[i] = from[rows_];
    b2_[i] = from[rows_ + 1];
    const int normal = problem_.normalOf[equations_ + i];
    normalOf_[i] = normal < 0 ? -1 : normal - problem_.equations;
  }
  return true;
}

}  // namespace pongsim::physics
