#pragma once

#include <cstddef>

namespace pongsim::physics {

/// The upper triangle of a symmetric matrix, with further columns behind it, in row-major order.
struct UpperRows {
  double* data = nullptr;
  /// Numbers per row: a multiple of four, of which the unused ones are zero.
  std::size_t width = 0;
  std::size_t rows = 0;

  double* row(std::size_t number) const { return data + number * width; }
};

/// @return The next multiple of four, which is as wide as rows must be for so many columns.
constexpr std::size_t widthFor(std::size_t columns) { return (columns + 3) / 4 * 4; }

/// Eliminates the first `count` rows from those behind them: these become the Schur complement, with its right-hand
/// sides, and the first rows become D L^T. Rows that are not coupled cost nothing. The order of all sums is the same on
/// every processor.
///
/// Reference: G. H. Golub, C. F. Van Loan, Matrix Computations, 3.2 (outer products) and 4.1 (L D L^T).
/// @param inverseD Of `count` numbers: 1 / D.
/// @return False where the matrix is not positive definite.
bool eliminate(const UpperRows& matrix, std::size_t count, double* inverseD);

/// Finds x of rows that were eliminated, from `first` to `end`, where those of `end` up to `count` are known.
/// @param side Column of the right-hand side.
void substitute(const UpperRows& matrix, const double* inverseD, std::size_t first, std::size_t end, std::size_t count,
                std::size_t side, double* x);

}  // namespace pongsim::physics
