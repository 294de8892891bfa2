#include "physics/solving/elimination.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pongsim::physics {
namespace {

/// The matrix that is 2 on its diagonal and `beside` next to it, with a right-hand side of ones behind it.
std::vector<double> chain(std::size_t rows, double beside) {
  const std::size_t width = widthFor(rows + 1);
  std::vector<double> data(rows * width, 0.0);
  for (std::size_t i = 0; i < rows; ++i) {
    data[i * width + i] = 2;
    if (i + 1 < rows) data[i * width + i + 1] = beside;
    data[i * width + rows] = 1;
  }
  return data;
}

TEST(Elimination, SolvesSystemsOfAllSizes) {
  for (std::size_t rows = 1; rows < 20; ++rows) {
    std::vector<double> data = chain(rows, -1), inverse(rows), x(rows);
    const UpperRows matrix{data.data(), widthFor(rows + 1), rows};
    ASSERT_TRUE(eliminate(matrix, rows, inverse.data()));
    substitute(matrix, inverse.data(), 0, rows, rows, rows, x.data());
    for (std::size_t i = 0; i < rows; ++i) {
      const double before = i > 0 ? x[i - 1] : 0, behind = i + 1 < rows ? x[i + 1] : 0;
      EXPECT_NEAR(2 * x[i] - before - behind, 1, 1e-12) << i << " of " << rows;
    }
  }
}

TEST(Elimination, LeavesTheSchurComplementBehind) {
  // of 2 -1 0, -1 2 -1, 0 -1 2 without its first two rows: 2 - 1 / (2 - 1 / 2)
  std::vector<double> data = chain(3, -1), inverse(2);
  const UpperRows matrix{data.data(), 4, 3};
  ASSERT_TRUE(eliminate(matrix, 2, inverse.data()));
  EXPECT_NEAR(matrix.row(2)[2], 4.0 / 3, 1e-15);
  EXPECT_NEAR(matrix.row(2)[3], 2, 1e-15);
}

TEST(Elimination, SubstitutesWhereOthersAreKnown) {
  // all rows know of each other; those behind the eliminated ones have any x
  for (std::size_t rows = 2; rows < 30; ++rows) {
    const std::size_t width = widthFor(rows + 1);
    for (std::size_t end = 1; end < rows; end += 3) {
      std::vector<double> data(rows * width, 0.0), inverse(rows), x(rows, 0.0);
      const auto entry = [rows](std::size_t i, std::size_t j) {
        return i == j ? static_cast<double>(rows) : 1 / static_cast<double>(1 + i + j);
      };
      for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = i; j < rows; ++j) data[i * width + j] = entry(i, j);
        data[i * width + rows] = static_cast<double>(i) - 2;
      }
      const UpperRows matrix{data.data(), width, rows};
      ASSERT_TRUE(eliminate(matrix, end, inverse.data()));
      for (std::size_t i = end; i < rows; ++i) x[i] = 0.5 * static_cast<double>(i % 7) - 1;
      substitute(matrix, inverse.data(), 0, end, rows, rows, x.data());
      for (std::size_t i = 0; i < end; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < rows; ++j) sum += entry(std::min(i, j), std::max(i, j)) * x[j];
        EXPECT_NEAR(sum, static_cast<double>(i) - 2, 1e-12) << i << " of " << end << " of " << rows;
      }
    }
  }
}

TEST(Elimination, RefusesWhatIsNotPositiveDefinite) {
  std::vector<double> data = chain(5, 3), inverse(5);
  EXPECT_FALSE(eliminate({data.data(), widthFor(6), 5}, 5, inverse.data()));
}

}  // namespace
}  // namespace pongsim::physics
