#include "physics/lcp/lcp.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace pongsim::physics {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// A problem and its memory.
struct Case {
  std::vector<double> A, b, lowest, highest;
  std::vector<int> normalOf;

  std::size_t rows() const { return b.size(); }
  Lcp::Problem problem() const {
    const int count = static_cast<int>(b.size());
    return {count, A.data(), count, b.data(), lowest.data(), highest.data(), normalOf.data()};
  }
};

/// A = J J^T, with as many directions of motion as there are, which may be fewer than rows.
Case randomCase(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const std::size_t equations = random() % 20, contacts = random() % 12;
  const std::size_t rows = equations + 3 * contacts;
  const std::size_t motions = 6 + random() % (rows + 6);
  std::vector<double> J(rows * motions);
  for (double& value : J) value = normal(random);
  Case made;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < rows; ++j) {
      double sum = i == j ? 1e-5 : 0;
      for (std::size_t k = 0; k < motions; ++k) sum += J[i * motions + k] * J[j * motions + k];
      made.A.push_back(sum);
    }
    made.b.push_back(normal(random));
    const bool isFriction = i >= equations + contacts;
    const bool isNormal = !isFriction && i >= equations;
    const bool isMotor = i < equations && random() % 4 == 0;
    made.lowest.push_back(isNormal ? 0 : isFriction ? -0.5 : isMotor ? -1 : -kEndless);
    made.highest.push_back(isNormal ? kEndless : isFriction ? 0.5 : isMotor ? 1 : kEndless);
    made.normalOf.push_back(isFriction ? static_cast<int>(equations + (i - equations - contacts) / 2) : -1);
  }
  return made;
}

/// Fails the test if a row does not meet its condition. Friction is bounded by the normal x of an earlier stage, which
/// is unknown here, so only its direction is checked.
void expectConditions(const Case& which, const std::vector<double>& x) {
  for (std::size_t i = 0; i < which.rows(); ++i) {
    double w = -which.b[i], scale = 1;
    for (std::size_t j = 0; j < which.rows(); ++j) {
      w += which.A[i * which.rows() + j] * x[j];
      scale += std::abs(which.A[i * which.rows() + j] * x[j]);
    }
    const double close = 1e-9 * scale;
    if (which.normalOf[i] >= 0) {
      EXPECT_TRUE(std::abs(w) <= close || w * x[i] <= 0) << "friction does not brake in row " << i;
      continue;
    }
    EXPECT_GE(x[i], which.lowest[i] - 1e-9) << i;
    EXPECT_LE(x[i], which.highest[i] + 1e-9) << i;
    EXPECT_TRUE(x[i] <= which.lowest[i] + 1e-9 || w <= close) << i;
    EXPECT_TRUE(x[i] >= which.highest[i] - 1e-9 || w >= -close) << i;
  }
}

TEST(Lcp, MeetsAllConditionsOfRandomProblems) {
  std::mt19937 random(1);
  Lcp lcp;
  for (int i = 0; i < 500; ++i) {
    const Case which = randomCase(random);
    std::vector<double> x(which.rows());
    ASSERT_TRUE(lcp.solve(which.problem(), x.data())) << i;
    expectConditions(which, x);
    if (HasFailure()) FAIL() << "problem " << i << " of " << which.rows() << " rows";
  }
}

TEST(Lcp, LetsGoOfContactsAndHoldsWithWhatFrictionThereIs) {
  // a weight of 10 on a floor, pulled by 3 along it: friction of 0.5 holds
  const Case held{{1, 0, 0, 1}, {10, 3}, {0, -0.5}, {kEndless, 0.5}, {-1, 0}};
  std::vector<double> x(2);
  Lcp lcp;
  ASSERT_TRUE(lcp.solve(held.problem(), x.data()));
  EXPECT_EQ(x, (std::vector<double>{10, 3}));
  // pulled by 8 it slides
  Case sliding = held;
  sliding.b[1] = 8;
  ASSERT_TRUE(lcp.solve(sliding.problem(), x.data()));
  EXPECT_EQ(x, (std::vector<double>{10, 5}));
  // and flying off it has neither
  Case flying = held;
  flying.b[0] = -10;
  ASSERT_TRUE(lcp.solve(flying.problem(), x.data()));
  EXPECT_EQ(x, (std::vector<double>{0, 0}));
}

TEST(Lcp, StandsOnMorePointsThanItNeeds) {
  // four equal points, distinguished only by a little softness; two of them have no load
  Case table{
      std::vector<double>(16, 1), {1, 1, 0, 0}, {0, 0, 0, 0}, std::vector<double>(4, kEndless), {-1, -1, -1, -1}};
  for (std::size_t i = 0; i < 4; ++i) table.A[5 * i] += 1e-5;
  std::vector<double> x(4);
  Lcp lcp;
  ASSERT_TRUE(lcp.solve(table.problem(), x.data()));
  expectConditions(table, x);
  EXPECT_NEAR(x[0] + x[1] + x[2] + x[3], 1, 1e-4);
}

TEST(Lcp, HoldsAnAxleAcrossByTheFrictionOfBothItsWheels) {
  // both wheels are equal except for softness, and are commanded 3.1 and 3: one is at its bound, and the other one
  // provides the rest
  const double s = 1 + 1e-5;
  const std::vector<double> A{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, s, 1, 0, 0, 1, s};
  Case axle{A, {8, 4, 3.1, 3}, {0, 0, -0.5, -0.5}, {kEndless, kEndless, 0.5, 0.5}, {-1, -1, 0, 1}};
  std::vector<double> x(4);
  Lcp lcp;
  ASSERT_TRUE(lcp.solve(axle.problem(), x.data()));
  expectConditions(axle, x);
  EXPECT_NEAR(x[2], 4, 1e-3);
  EXPECT_NEAR(x[3], -1, 1e-3);
  // pulled harder than both can hold
  axle.b[2] = axle.b[3] = 10;
  ASSERT_TRUE(lcp.solve(axle.problem(), x.data()));
  EXPECT_EQ(x, (std::vector<double>{8, 4, 4, 2}));
}

TEST(Lcp, SaysWhatCantBeSolved) {
  const Case contradiction{{1, 1, 1, 1}, {1, 2}, {-kEndless, -kEndless}, {kEndless, kEndless}, {-1, -1}};
  std::vector<double> x(2);
  Lcp lcp;
  EXPECT_FALSE(lcp.solve(contradiction.problem(), x.data()));
}

}  // namespace
}  // namespace pongsim::physics
