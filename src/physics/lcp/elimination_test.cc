#include "physics/lcp/elimination.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

/// As above, of rows that all know of each other, or of which some do not.
std::vector<double> wholeMatrix(std::size_t rows, bool hasGaps) {
  const std::size_t width = widthFor(rows + 1);
  std::vector<double> data(rows * width, 0.0);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = i; j < rows; ++j) {
      if (hasGaps && (i + 2 * j) % 5 == 0) continue;
      data[i * width + j] = 1 / (1.0 + static_cast<double>(i + j));
    }
    data[i * width + i] = 4;
    data[i * width + rows] = 1 + static_cast<double>(i);
  }
  return data;
}

TEST(Elimination, SolvesRowsThatKnowOfEachOther) {
  for (const bool hasGaps : {false, true}) {
    for (std::size_t rows = 1; rows < 20; ++rows) {
      const std::size_t width = widthFor(rows + 1);
      const std::vector<double> whole = wholeMatrix(rows, hasGaps);
      std::vector<double> data = whole, inverse(rows), x(rows);
      const UpperRows matrix{data.data(), width, rows};
      ASSERT_TRUE(eliminate(matrix, rows, inverse.data()));
      substitute(matrix, inverse.data(), 0, rows, rows, rows, x.data());
      for (std::size_t i = 0; i < rows; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < rows; ++j) sum += whole[std::min(i, j) * width + std::max(i, j)] * x[j];
        EXPECT_NEAR(sum, whole[i * width + rows], 1e-12) << i << " of " << rows;
      }
    }
  }
}

// the order of all sums is that of taking row after row, four of them together behind their panel
TEST(Elimination, HasTheBitsOfRowAfterRow) {
  for (const bool hasGaps : {false, true}) {
    constexpr std::size_t kRows = 7, kTaken = 4;
    const std::size_t width = widthFor(kRows + 1);
    std::vector<double> data = wholeMatrix(kRows, hasGaps), expected = data, inverse(kTaken);
    ASSERT_TRUE(eliminate({data.data(), width, kRows}, kTaken, inverse.data()));
    for (std::size_t j = 0; j < kTaken; ++j) {
      for (std::size_t i = j + 1; i < kTaken; ++i) {
        const double factor = expected[j * width + i] * (1 / expected[j * width + j]);
        for (std::size_t k = i; k < width; ++k) expected[i * width + k] -= factor * expected[j * width + k];
      }
    }
    for (std::size_t i = kTaken; i < kRows; ++i) {
      std::array<double, kTaken> factors;
      for (std::size_t j = 0; j < kTaken; ++j) {
        factors[j] = expected[j * width + i] * (1 / expected[j * width + j]);
      }
      for (std::size_t k = i; k < width; ++k) {
        const auto part = [&](std::size_t j) { return factors[j] * expected[j * width + k]; };
        expected[i * width + k] -= (part(0) + part(1)) + (part(2) + part(3));
      }
    }
    for (std::size_t i = 0; i < kRows; ++i) {
      for (std::size_t k = i; k < width; ++k) {
        EXPECT_EQ(data[i * width + k], expected[i * width + k]) << i << ", " << k;
      }
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
