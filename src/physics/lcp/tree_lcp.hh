#pragma once

#include <span>
#include <vector>

#include "physics/lcp/block_matrix.hh"
#include "physics/lcp/lcp.hh"

namespace pongsim::physics {

/// Solves mixed linear complementarity problems as `ReducedLcp` does, where the equations are those of joints that are
/// not all coupled with each other: trees and chains of links, of any length.
class TreeLcp {
 public:
  /// Of the rows with bounds, in their order.
  struct Bounds {
    /// How many rows are not of friction; they stand before those of friction.
    int unfrictionalRows = 0;
    /// As in `Lcp::Problem`.
    const double* lowest = nullptr;
    const double* highest = nullptr;
    const int* normalOf = nullptr;
  };

  /// What to write the problem to, after its `begin`; `solve` uses it up. The first right-hand side is that of all
  /// rows, the second one that of the rows without friction, which the others leave at zero.
  BlockMatrix& matrix() { return matrix_; }

  /// Finds x as `Lcp::solve` does.
  /// @param x Of `matrix().size()` numbers.
  /// @return Whether a solution was found; otherwise `x` is undefined.
  bool solve(const Bounds& bounds, std::span<double> x);

  /// Finds x for the other right-hand side of the problem that was solved last, likewise. That of friction is zero.
  bool solveSecond(std::span<double> x);

 private:
  void takeReduced();
  Lcp::Problem rest(int rows, const double* b) const;
  void place(int rows, std::span<double> x) const;

  BlockMatrix matrix_;
  Bounds bounds_;
  /// What is left of the rows with bounds, in their order.
  int count_ = 0;
  std::vector<double> A_;
  std::vector<double> b_;
  std::vector<double> b2_;
  std::vector<double> found_;
  Lcp lcp_;
};

}  // namespace pongsim::physics
