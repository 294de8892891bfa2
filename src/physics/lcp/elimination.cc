#include "physics/lcp/elimination.hh"

#include <algorithm>
#include <cassert>

#include "physics/lcp/dot.hh"
#include "physics/lcp/four.hh"

namespace pongsim::physics {

namespace {

/// Rows that are eliminated together, which spares three quarters of the way to memory and back.
constexpr std::size_t kPanel = 4;

/// row -= factor * pivot, from the column on.
[[gnu::always_inline]] inline void subtractOne(double* row, double factor, const double* pivot, std::size_t column,
                                               std::size_t width) {
  for (std::size_t k = column / 4 * 4; k < width; k += 4) {
    Four& to = *reinterpret_cast<Four*>(row + k);
    to -= factor * *reinterpret_cast<const Four*>(pivot + k);
  }
}

/// Takes four pivots, each a row further than the one before. `factors` are of this row, four apart.
[[gnu::always_inline]] inline void subtractFour(double* row, const double* factors, const double* pivots,
                                                std::size_t column, std::size_t width) {
  const double f0 = factors[0], f1 = factors[4], f2 = factors[8], f3 = factors[12];
  for (std::size_t k = column; k < width; k += 4) {
    const auto pivot = [&](std::size_t number) -> const Four& {
      return *reinterpret_cast<const Four*>(pivots + number * width + k);
    };
    Four& to = *reinterpret_cast<Four*>(row + k);
    to -= (f0 * pivot(0) + f1 * pivot(1)) + (f2 * pivot(2) + f3 * pivot(3));
  }
}

/// Takes fewer pivots one after the other; those whose factor is zero not at all.
template <std::size_t kCount>
[[gnu::always_inline]] inline void subtractSome(double* row, const double* factors, const double* pivots,
                                                std::size_t column, std::size_t width) {
  bool isOneZero = false;
  for (std::size_t p = 0; p < kCount; ++p) isOneZero = isOneZero || factors[p] == 0;
  if (isOneZero) {
    for (std::size_t p = 0; p < kCount; ++p) {
      if (factors[p] != 0) subtractOne(row, factors[p], pivots + p * width, column, width);
    }
    return;
  }
  for (std::size_t k = column / 4 * 4; k < width; k += 4) {
    Four to = *reinterpret_cast<const Four*>(row + k);
    for (std::size_t p = 0; p < kCount; ++p) to -= factors[p] * *reinterpret_cast<const Four*>(pivots + p * width + k);
    *reinterpret_cast<Four*>(row + k) = to;
  }
}

/// Takes the rows of a panel out of each other.
/// @param count How many they are.
[[gnu::always_inline]] inline bool eliminatePanel(const UpperRows& matrix, std::size_t first, std::size_t count,
                                                  double* inverseD) {
  for (std::size_t j = first; j < first + count; ++j) {
    const double* const pivot = matrix.row(j);
    if (!(pivot[j] > 0)) return false;
    inverseD[j] = 1 / pivot[j];
    for (std::size_t i = j + 1; i < first + count; ++i) {
      const double factor = pivot[i] * inverseD[j];
      if (factor != 0) subtractOne(matrix.row(i), factor, pivot, i, matrix.width);
    }
  }
  return true;
}

/// Likewise of four rows that all know of each other: what they take is found before they are gone through, once.
/// @return Whether they do; else nothing has changed but `inverseD`.
[[gnu::always_inline]] inline bool eliminateFour(const UpperRows& matrix, std::size_t first, double* inverseD) {
  const std::size_t width = matrix.width;
  double* const row0 = matrix.row(first);
  double* const row1 = row0 + width;
  double* const row2 = row1 + width;
  double* const row3 = row2 + width;
  const double* const a = row0 + first;
  const double i0 = 1 / a[0];
  const double f01 = a[1] * i0, f02 = a[2] * i0, f03 = a[3] * i0;
  const double b1 = row1[first + 1] - f01 * a[1], b2 = row1[first + 2] - f01 * a[2], b3 = row1[first + 3] - f01 * a[3];
  const double i1 = 1 / b1;
  const double f12 = b2 * i1, f13 = b3 * i1;
  const double c2 = (row2[first + 2] - f02 * a[2]) - f12 * b2, c3 = (row2[first + 3] - f02 * a[3]) - f12 * b3;
  const double i2 = 1 / c2;
  const double f23 = c3 * i2;
  const double d3 = ((row3[first + 3] - f03 * a[3]) - f13 * b3) - f23 * c3;
  if (!(a[0] > 0 && b1 > 0 && c2 > 0 && d3 > 0)) return false;
  if (f01 == 0 || f02 == 0 || f03 == 0 || f12 == 0 || f13 == 0 || f23 == 0) return false;
  inverseD[first] = i0;
  inverseD[first + 1] = i1;
  inverseD[first + 2] = i2;
  inverseD[first + 3] = 1 / d3;
  for (std::size_t k = first; k < width; k += 4) {
    const Four p0 = *reinterpret_cast<const Four*>(row0 + k);
    const Four p1 = *reinterpret_cast<const Four*>(row1 + k) - f01 * p0;
    const Four p2 = (*reinterpret_cast<const Four*>(row2 + k) - f02 * p0) - f12 * p1;
    *reinterpret_cast<Four*>(row1 + k) = p1;
    *reinterpret_cast<Four*>(row2 + k) = p2;
    *reinterpret_cast<Four*>(row3 + k) = ((*reinterpret_cast<const Four*>(row3 + k) - f03 * p0) - f13 * p1) - f23 * p2;
  }
  return true;
}

/// Takes a panel of fewer than four rows out of all behind it.
template <std::size_t kCount>
[[gnu::always_inline]] inline bool eliminateLast(const UpperRows& matrix, std::size_t first, double* inverseD) {
  if (!eliminatePanel(matrix, first, kCount, inverseD)) return false;
  const double* const pivots = matrix.row(first);
  for (std::size_t i = first + kCount; i < matrix.rows; ++i) {
    double factors[kCount];
    for (std::size_t p = 0; p < kCount; ++p) factors[p] = pivots[p * matrix.width + i] * inverseD[first + p];
    subtractSome<kCount>(matrix.row(i), factors, pivots, i, matrix.width);
  }
  return true;
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
  // what remains of each right-hand side, and the coefficients of the four x in it
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
  const std::size_t width = matrix.width;
  std::size_t first = 0;
  for (; first + kPanel <= count; first += kPanel) {
    if (!eliminateFour(matrix, first, inverseD) && !eliminatePanel(matrix, first, kPanel, inverseD)) return false;
    const double* const pivots = matrix.row(first);
    // those behind the panel are taken from together, and four of them find their factors side by side
    for (std::size_t i = first + kPanel; i < matrix.rows; i += 4) {
      Four factors[kPanel];
      for (std::size_t p = 0; p < kPanel; ++p) {
        factors[p] = *reinterpret_cast<const Four*>(pivots + p * width + i) * inverseD[first + p];
      }
      const auto areApart = (factors[0] == 0) & (factors[1] == 0) & (factors[2] == 0) & (factors[3] == 0);
      const std::size_t rows = std::min(matrix.rows - i, std::size_t{4});
      for (std::size_t r = 0; r < rows; ++r) {
        if (areApart[r] != 0) continue;
        subtractFour(matrix.row(i + r), reinterpret_cast<const double*>(factors) + r, pivots, i, width);
      }
    }
  }
  switch (count - first) {
    case 1:
      return eliminateLast<1>(matrix, first, inverseD);
    case 2:
      return eliminateLast<2>(matrix, first, inverseD);
    case 3:
      return eliminateLast<3>(matrix, first, inverseD);
    default:
      return true;
  }
}

}  // namespace

bool eliminate(const UpperRows& matrix, std::size_t count, double* inverseD) {
  assert(count <= matrix.rows && matrix.rows <= matrix.width && matrix.width % 4 == 0);
  return eliminateColumns(matrix, count, inverseD);
}

void substitute(const UpperRows& matrix, const double* inverseD, std::size_t first, std::size_t end, std::size_t count,
                std::size_t side, double* x) {
  substituteRows(matrix, inverseD, first, end, count, side, x);
}

}  // namespace pongsim::physics
