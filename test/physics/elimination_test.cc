#include "physics/elimination.hh"

#include <gtest/gtest.h>

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

TEST(Elimination, RefusesWhatIsNotPositiveDefinite) {
  std::vector<double> data = chain(5, 3), inverse(5);
  EXPECT_FALSE(eliminate({data.data(), widthFor(6), 5}, 5, inverse.data()));
}

}  // namespace
}  // namespace pongsim::physics
