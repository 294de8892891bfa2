#include "physics/solving/elimination.hh"

#include <algorithm>

#include "physics/solving/dot.hh"
#include "physics/solving/four.hh"

namespace pongsim::physics {

namespace {

/// Rows that are eliminated together, which spares three quarters of the way to memory and back.
constexpr std::size_t kPanel = 4;

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

/// Finds four x side by side, from `first` on, a multiple of four. Those behind them are known.
[[gnu::always_inline]] inline void substituteFour(const UpperRows& matrix, const double* inverseD, std::size_t first,
                                                  std::size_t count, std::size_t side, double* x) {
  const double* const rows = matrix.row(first);
  const std::size_t width = matrix.width;
  Four a{}, b{}, c{}, d{};
  std::size_t k = first + 4;
  for (; k + 4 <= count; k += 4) {
    const Four known = *reinterpret_cast<const Loose*>(x + k);
    a += *reinterpret_cast<const Four*>(rows + k) * known;
    b += *reinterpret_cast<const Four*>(rows + width + k) * known;
    c += *reinterpret_cast<const Four*>(rows + 2 * width + k) * known;
    d += *reinterpret_cast<const Four*>(rows + 3 * width + k) * known;
  }
  Four sums;
  sumUp(a, b, c, d, sums);
  // what is left of each right-hand side, and what the x of the four count for in it
  double left[4], ofNext[4][4];
  for (std::size_t r = 0; r < 4; ++r) {
    const double* const row = rows + r * width;
    double sum = sums[r];
    for (std::size_t tail = k; tail < count; ++tail) sum += row[tail] * x[tail];
    left[r] = (row[side] - sum) * inverseD[first + r];
    for (std::size_t j = r + 1; j < 4; ++j) ofNext[r][j] = row[first + j] * inverseD[first + r];
  }
  const double x3 = left[3];
  const double x2 = left[2] - ofNext[2][3] * x3;
  const double x1 = (left[1] - ofNext[1][3] * x3) - ofNext[1][2] * x2;
  const double x0 = ((left[0] - ofNext[0][3] * x3) - ofNext[0][2] * x2) - ofNext[0][1] * x1;
  *reinterpret_cast<Loose*>(x + first) = Loose{x0, x1, x2, x3};
}

PONGSIM_WIDE void substituteRows(const UpperRows& matrix, const double* inverseD, std::size_t first, std::size_t end,
                                 std::size_t count, std::size_t side, double* x) {
  std::size_t i = end;
  while (i > first) {
    if (i % 4 == 0 && i >= first + 4) {
      i -= 4;
      substituteFour(matrix, inverseD, i, count, side, x);
    } else {
      --i;
      const double* const row = matrix.row(i);
      x[i] = (row[side] - dot(row + i + 1, x + i + 1, count - i - 1)) * inverseD[i];
    }
  }
}

PONGSIM_WIDE bool eliminateColumns(const UpperRows& matrix, std::size_t count, double* inverseD) {
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

bool eliminate(const UpperRows& matrix, std::size_t count, double* inverseD) {
  return eliminateColumns(matrix, count, inverseD);
}

void substitute(const UpperRows& matrix, const double* inverseD, std::size_t first, std::size_t end, std::size_t count,
                std::size_t side, double* x) {
  substituteRows(matrix, inverseD, first, end, count, side, x);
}

}  // namespace pongsim::physics
