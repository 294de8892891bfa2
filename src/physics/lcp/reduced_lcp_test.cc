#include "physics/lcp/reduced_lcp.hh"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace pongsim::physics {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// Some equations, contacts and their friction; A = J J^T.
struct ReducedCase {
  int equations = 0;
  int contacts = 0;
  std::vector<double> A, b, b2, lowest, highest;
  std::vector<int> normalOf;

  int rows() const { return equations + 3 * contacts; }
  bool solveBy(ReducedLcp& lcp, std::vector<double>& x) const {
    const UpperRows matrix = lcp.begin(rows());
    const auto count = static_cast<std::size_t>(rows());
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i; j < count; ++j) matrix.row(i)[j] = A[i * count + j];
      matrix.row(i)[count] = b[i];
      if (i < static_cast<std::size_t>(equations + contacts)) matrix.row(i)[count + 1] = b2[i];
    }
    return lcp.solve({equations, equations + contacts, lowest.data(), highest.data(), normalOf.data()}, x);
  }
  Lcp::Problem whole(int count, const std::vector<double>& side) const {
    return {count, A.data(), rows(), side.data(), lowest.data(), highest.data(), normalOf.data()};
  }
};

ReducedCase randomReducedCase(std::mt19937& random) {
  std::normal_distribution<double> normal;
  ReducedCase made;
  made.equations = static_cast<int>(random() % 20);
  made.contacts = static_cast<int>(random() % 14);
  const auto rows = static_cast<std::size_t>(made.rows());
  const std::size_t motions = rows + 6;
  std::vector<double> J(rows * motions);
  for (double& value : J) value = normal(random);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < rows; ++j) {
      double sum = i == j ? 1e-2 : 0;
      for (std::size_t k = 0; k < motions; ++k) sum += J[i * motions + k] * J[j * motions + k];
      made.A.push_back(sum);
    }
    const int row = static_cast<int>(i);
    const bool isEquation = row < made.equations;
    const bool isFriction = row >= made.equations + made.contacts;
    made.b.push_back(normal(random));
    made.b2.push_back(normal(random));
    made.lowest.push_back(isEquation ? -kNoEnd : isFriction ? -0.5 : 0);
    made.highest.push_back(isFriction ? 0.5 : kNoEnd);
    made.normalOf.push_back(isFriction ? made.equations + (row - made.equations - made.contacts) / 2 : -1);
  }
  return made;
}

TEST(ReducedLcp, FindsWhatTheWholeProblemHas) {
  std::mt19937 random(1);
  ReducedLcp reduced;
  Lcp whole;
  for (int i = 0; i < 300; ++i) {
    const ReducedCase which = randomReducedCase(random);
    if (which.rows() == 0) continue;
    std::vector<double> x(static_cast<std::size_t>(which.rows())), expected(x.size());
    ASSERT_TRUE(which.solveBy(reduced, x));
    ASSERT_TRUE(whole.solve(which.whole(which.rows(), which.b), expected.data()));
    for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(x[k], expected[k], 1e-7) << "case " << i << ", row " << k;
    const int unfrictional = which.equations + which.contacts;
    if (unfrictional == 0) continue;
    ASSERT_TRUE(reduced.solveSecond(x));
    ASSERT_TRUE(whole.solve(which.whole(unfrictional, which.b2), expected.data()));
    for (std::size_t k = 0; k < static_cast<std::size_t>(unfrictional); ++k) {
      EXPECT_NEAR(x[k], expected[k], 1e-7) << "second side of case " << i << ", row " << k;
    }
  }
}

TEST(ReducedLcp, RefusesWhatIsNotPositiveDefinite) {
  ReducedCase which;
  which.equations = 2;
  which.A = {1, 2, 2, 1};
  which.b = which.b2 = {1, 1};
  which.lowest = {-kNoEnd, -kNoEnd};
  which.highest = {kNoEnd, kNoEnd};
  which.normalOf = {-1, -1};
  ReducedLcp reduced;
  std::vector<double> x(2);
  EXPECT_FALSE(which.solveBy(reduced, x));
}

}  // namespace
}  // namespace pongsim::physics
