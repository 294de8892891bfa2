#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "physics/lcp/elimination.hh"
#include "physics/lcp/lcp.hh"

namespace pongsim::physics {

/// Solves mixed linear complementarity problems of which many rows are equations, as those of joints are: these are
/// eliminated once, with two right-hand sides, and `Lcp` solves what is left. Of a robot that is 9 rows of 24.
class ReducedLcp {
 public:
  struct Problem {
    /// How many rows have no bounds; they stand before all others.
    int equations = 0;
    /// How many rows are not of friction, the equations among them; they stand before those of friction.
    int unfrictionalRows = 0;
    /// As in `Lcp::Problem`.
    const double* lowest = nullptr;
    const double* highest = nullptr;
    const int* normalOf = nullptr;
  };

  /// Memory for a problem of so many rows: a symmetric and positive definite matrix, of which what stands before the
  /// diagonal is not read, and two right-hand sides in the columns behind it, that of all rows and that of the rows
  /// without friction, which the others leave at zero.
  /// @return With zeros in all of it; `solve` uses it up.
  UpperRows begin(int rows);

  /// Finds x like `Lcp::solve`, for the problem that was written to the memory.
  /// @param x Of `rows` numbers.
  /// @return Whether a solution was found; otherwise `x` is undefined.
  bool solve(const Problem& problem, std::span<double> x);

  /// Finds x for the other right-hand side of the problem that was solved last, without friction.
  /// @param x Of `unfrictionalRows` numbers or more.
  /// @return Whether it did, likewise.
  bool solveSecond(std::span<double> x);

 private:
  bool reduce();
  UpperRows upper() { return {U_.data(), width_, rows_}; }
  Lcp::Problem rest(std::size_t end, const double* b) const;

  Problem problem_;
  std::size_t rows_ = 0;
  std::size_t equations_ = 0;
  std::size_t unfrictional_ = 0;
  std::size_t width_ = 0;
  /// The matrix, with both right-hand sides behind it.
  std::vector<double> U_;
  std::vector<double> inverseD_;
  /// What is left.
  std::vector<double> A_;
  std::vector<double> b_;
  std::vector<double> b2_;
  std::vector<int> normalOf_;
  Lcp lcp_;
};

}  // namespace pongsim::physics
