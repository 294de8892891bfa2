#include "physics/solving/block_rows.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace pongsim::physics {
namespace {

/// Four bodies in a chain, joints with as many rows as `rows` says between them, and one row with bounds at the third.
struct Chain {
  explicit Chain(std::mt19937& random) {
    std::normal_distribution<double> normal;
    order.find(joints);
    blocks.begin(4, 2 * joints.size());
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
      for (const std::size_t end : {0U, 1U}) {
        BlockRows::End& added = blocks.add(static_cast<int>(joint), joints[joint][end]);
        for (std::size_t lane = 0; lane < static_cast<std::size_t>(rows[joint]); ++lane) {
          std::array<double, 3> linear, angular;
          for (double& value : linear) value = normal(random);
          for (double& value : angular) value = normal(random);
          BlockRows::set(added, lane, linear, angular);
          for (std::size_t k = 0; k < 3; ++k) J[joint][lane][6 * static_cast<std::size_t>(added.body) + k] = linear[k];
          for (std::size_t k = 0; k < 3; ++k)
            J[joint][lane][6 * static_cast<std::size_t>(added.body) + k + 3] = angular[k];
        }
        along[joint][end] = BlockRows::respond(added, inertia, velocity);
      }
    }
  }
  /// What the body answers.
  BlockRows::Motion response(const std::array<double, 24>& row, std::size_t body) const {
    BlockRows::Motion result{};
    for (std::size_t k = 0; k < 3; ++k) {
      result[k] = inertia.inverseMass * row[6 * body + k];
      for (std::size_t m = 0; m < 3; ++m) result[k + 3] += inertia.inverseMoments[3 * k + m] * row[6 * body + 3 + m];
    }
    return result;
  }
  double coupling(const std::array<double, 24>& a, const std::array<double, 24>& b) const {
    double sum = 0;
    for (std::size_t body = 0; body < 4; ++body) {
      const BlockRows::Motion answer = response(a, body);
      for (std::size_t k = 0; k < 6; ++k) sum += answer[k] * b[6 * body + k];
    }
    return sum;
  }

  const std::vector<JointBodies> joints = {{0, 1, -1}, {1, 2, -1}, {2, 3, -1}};
  const std::vector<int> rows = {5, 3, 6};
  const BlockRows::Inertia inertia{0.5, {2, 0.1, 0.2, 0.1, 3, 0.3, 0.2, 0.3, 4}};
  const BlockRows::Motion velocity{1, -2, 3, -4, 5, -6};
  JointOrder order;
  BlockRows blocks;
  std::array<std::array<std::array<double, 24>, 6>, 3> J{};
  std::array<std::array<BlockRows::RowValues, 2>, 3> along;
};

TEST(BlockRows, SeeHowFastBodiesMoveAlongThem) {
  std::mt19937 random(1);
  const Chain chain(random);
  for (std::size_t joint = 0; joint < 3; ++joint) {
    for (const std::size_t end : {0U, 1U}) {
      const auto body = static_cast<std::size_t>(chain.joints[joint][end]);
      for (std::size_t lane = 0; lane < BlockRows::kMostRows; ++lane) {
        double expected = 0;
        for (std::size_t k = 0; lane < 6 && k < 6; ++k)
          expected += chain.J[joint][lane][6 * body + k] * chain.velocity[k];
        EXPECT_NEAR(chain.along[joint][end][lane], expected, 1e-12);
      }
    }
  }
}

TEST(BlockRows, CoupleWhatActsOnTheSameBody) {
  std::mt19937 random(2);
  Chain chain(random);
  BlockMatrix A;
  const std::vector<BlockMatrix::BoundedEnd> ends = {{0, 2}};
  ASSERT_TRUE(A.begin(chain.order, chain.rows, 1, ends));
  chain.blocks.couple(chain.order, chain.rows, A);
  std::array<double, 24> boundedRow{};
  for (std::size_t k = 12; k < 18; ++k) boundedRow[k] = static_cast<double>(k) - 14;
  chain.blocks.couple(chain.order, chain.rows, 2, chain.response(boundedRow, 2), 0, A);
  for (int i = 0; i < 3; ++i) {
    const auto a = static_cast<std::size_t>(i);
    for (int j = 0; j < 3; ++j) {
      const int first = chain.order.placeOf(i), second = chain.order.placeOf(j);
      const auto later = chain.order.later(first);
      if (first != second && std::ranges::find(later, second) == later.end()) continue;
      const BlockMatrix::Block block = A.block(first, second);
      const auto b = static_cast<std::size_t>(j);
      for (std::size_t m = 0; m < static_cast<std::size_t>(chain.rows[a]); ++m) {
        for (std::size_t n = first == second ? m : 0; n < static_cast<std::size_t>(chain.rows[b]); ++n) {
          EXPECT_NEAR(block.data[m * block.stride + n], chain.coupling(chain.J[a][m], chain.J[b][n]), 1e-12);
        }
      }
    }
    if (i == 0) continue;
    const BlockMatrix::Block bounded = A.block(chain.order.placeOf(i), A.boundedPlace());
    for (std::size_t m = 0; m < static_cast<std::size_t>(chain.rows[a]); ++m) {
      EXPECT_NEAR(bounded.data[m * bounded.stride], chain.coupling(chain.J[a][m], boundedRow), 1e-12);
    }
  }
}

TEST(BlockRows, GiveBodiesWhatImpulsesDo) {
  std::mt19937 random(3);
  Chain chain(random);
  BlockMatrix A;
  ASSERT_TRUE(A.begin(chain.order, chain.rows, 0, {}));
  std::vector<double> x(A.size(), 0.0);
  for (int joint = 0; joint < 3; ++joint) {
    for (int row = 0; row < chain.rows[static_cast<std::size_t>(joint)]; ++row) {
      x[static_cast<std::size_t>(A.indexOf(chain.order.placeOf(joint), row))] = joint + 0.25 * row - 1;
    }
  }
  for (std::size_t body = 0; body < 4; ++body) {
    BlockRows::Motion change{1, 1, 1, 1, 1, 1}, expected = change;
    chain.blocks.apply(static_cast<int>(body), chain.order, A, x.data(), change);
    for (std::size_t joint = 0; joint < 3; ++joint) {
      for (std::size_t row = 0; row < static_cast<std::size_t>(chain.rows[joint]); ++row) {
        const BlockRows::Motion answer = chain.response(chain.J[joint][row], body);
        const double impulse = static_cast<double>(joint) + 0.25 * static_cast<double>(row) - 1;
        for (std::size_t k = 0; k < 6; ++k) expected[k] += impulse * answer[k];
      }
    }
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(change[k], expected[k], 1e-12);
  }
}

}  // namespace
}  // namespace pongsim::physics
