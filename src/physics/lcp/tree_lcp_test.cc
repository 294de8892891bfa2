#include "physics/lcp/tree_lcp.hh"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

#include "physics/lcp/lcp.hh"
#include "support/physics/tree_case.hh"

namespace pongsim::physics {
namespace {

using test::TreeCase;

/// As `Lcp` solves the problem of the first `count` rows, those of joints among them.
std::vector<double> solvedWhole(const TreeCase& which, std::size_t count, const std::vector<double>& b) {
  std::vector<double> A, lowest(which.firstBounded(), -TreeCase::kNoEnd),
      highest(which.firstBounded(), TreeCase::kNoEnd);
  std::vector<int> normalOf(which.firstBounded(), -1);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) A.push_back(which.A(i, j));
  }
  lowest.insert(lowest.end(), which.lowest.begin(), which.lowest.end());
  highest.insert(highest.end(), which.highest.begin(), which.highest.end());
  for (const int normal : which.normalOf) {
    normalOf.push_back(normal < 0 ? -1 : normal + static_cast<int>(which.firstBounded()));
  }
  std::vector<double> x(count);
  Lcp lcp;
  const int rows = static_cast<int>(count);
  EXPECT_TRUE(lcp.solve({rows, A.data(), rows, b.data(), lowest.data(), highest.data(), normalOf.data()}, x.data()));
  return x;
}

TEST(TreeLcp, FindsWhatTheWholeProblemHas) {
  std::mt19937 random(1);
  TreeLcp tree;
  for (int i = 0; i < 100; ++i) {
    const TreeCase which(random, 2 + i % 12, i % 3, i % 10);
    const auto [isTaken, indices] = which.writeTo(tree.matrix());
    ASSERT_TRUE(isTaken);
    std::vector<double> x(tree.matrix().size());
    const int unfrictional = which.unfrictional - static_cast<int>(which.firstBounded());
    ASSERT_TRUE(tree.solve({unfrictional, which.lowest.data(), which.highest.data(), which.normalOf.data()}, x));
    const std::vector<double> expected = solvedWhole(which, which.rows.size(), which.b);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(x[static_cast<std::size_t>(indices[k])], expected[k], 1e-7) << "case " << i << ", row " << k;
    }
    ASSERT_TRUE(tree.solveSecond(x));
    const std::vector<double> second = solvedWhole(which, static_cast<std::size_t>(which.unfrictional), which.b2);
    for (std::size_t k = 0; k < second.size(); ++k) {
      EXPECT_NEAR(x[static_cast<std::size_t>(indices[k])], second[k], 1e-7)
          << "second side of case " << i << ", row " << k;
    }
  }
}

}  // namespace
}  // namespace pongsim::physics
