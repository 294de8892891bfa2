#include "physics/elimination.hh"

#include <algorithm>

#include "physics/dot.hh"

namespace pongsim::physics {

namespace {

/// Rows that are eliminated together, which spares three quarters of the way to memory and back.
constexpr std::size_t kPanel = 4;

/// Four numbers side by side. Memory for rows has the alignment of two.
using Four [[gnu::vector_size(32), gnu::aligned(16), gnu::may_alias]] = double;

/// row -= factor * pivot, from the column on.
[[gnu::always_inline]] inline void takeOne(double* row, double factor, const double* pivot, std::size_t column,
                                           std::size_t width) {
  for (std::size_t k = column / 4 * 4; k < width; k += 4) {
    Four& to = *reinterpret_cast<Four*>(row + k);
    to -= factor * *reinterpret_cast<const Four*>(pivot + k);
  }
}

/// Takes four pivots, each a row further than the one before.
[[gnu::always_inline]] inline void takeFour(double* row, const double* factors, const double* pivots,
                                            std::size_t column, std::size_t width) {
  const double f0 = factors[0], f1 = factors[1], f2 = factors[2], f3 = factors[3];
  for (std::size_t k = column / 4 * 4; k < width; k += 4) {
    const auto pivot = [&](std::size_t number) -> const Four& {
      return *reinterpret_cast<const Four*>(pivots + number * width + k);
    };
    Four& to = *reinterpret_cast<Four*>(row + k);
    to -= (f0 * pivot(0) + f1 * pivot(1)) + (f2 * pivot(2) + f3 * pivot(3));
  }
}

// of what wider registers do beside each other every number comes out the same
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
[[gnu::target_clones("avx2", "default")]]
#endif
bool eliminateColumns(const UpperRows& matrix, std::size_t count, double* inverseD) {
  for (std::size_t first = 0; first < count; first += kPanel) {
    const std::size_t end = std::min(first + kPanel, count);
    const bool isWhole = end - first == kPanel;
    for (std::size_t j = first; j < end; ++j) {
      const double* const pivot = matrix.row(j);
      if (!(pivot[j] > 0)) return false;
      inverseD[j] = 1 / pivot[j];
      // those behind the panel are taken from together
      for (std::size_t i = j + 1; i < (isWhole ? end : matrix.rows); ++i) {
        const double factor = pivot[i] * inverseD[j];
        if (factor != 0) takeOne(matrix.row(i), factor, pivot, i, matrix.width);
      }
    }
    if (!isWhole) break;
    const double* const pivots = matrix.row(first);
    for (std::size_t i = end; i < matrix.rows; ++i) {
      double factors[kPanel];
      bool isApart = true;
      for (std::size_t p = 0; p < kPanel; ++p) {
        factors[p] = pivots[p * matrix.width + i] * inverseD[first + p];
        isApart = isApart && factors[p] == 0;
      }
      if (!isApart) takeFour(matrix.row(i), factors, pivots, i, matrix.width);
    }
  }
  return true;
}

}  // namespace

// clones of a function that others call would be offered by the library
bool eliminate(const UpperRows& matrix, std::size_t count, double* inverseD) {
  return eliminateColumns(matrix, count, inverseD);
}

void substitute(const UpperRows& matrix, const double* inverseD, std::size_t first, std::size_t end, std::size_t count,
                std::size_t side, double* x) {
  for (std::size_t i = end; i-- > first;) {
    const double* const row = matrix.row(i);
    x[i] = (row[side] - dot(row + i + 1, x + i + 1, count - i - 1)) * inverseD[i];
  }
}

}  // namespace pongsim::physics
