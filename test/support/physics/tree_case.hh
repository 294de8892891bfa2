#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "physics/lcp/block_matrix.hh"
#include "physics/lcp/joint_order.hh"

namespace pongsim::test {

using physics::BlockMatrix;
using physics::JointBodies;
using physics::JointOrder;

/// Bodies of six motions each in a tree of joints, some loops among them, with contacts of single bodies and their
/// friction, and joints with bounds: J of all rows, and A = J J^T softened a little. Rows are those of joints, then of
/// contacts, then of friction.
struct TreeCase {
  static constexpr double kNoEnd = std::numeric_limits<double>::infinity();
  struct Row {
    int joint;
    std::vector<int> bodies;
  };

  TreeCase(std::mt19937& random, int bodyCount, int loops, int contacts) : bodies(bodyCount) {
    std::normal_distribution<double> normal;
    const auto any = [&random](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
    for (int child = 0; child < bodies + loops; ++child) {
      const int parent = child < bodies ? any(child + 1) - 1 : any(bodies);
      const int end = child < bodies ? child : (parent + 1 + any(bodies - 1)) % bodies;
      joints.push_back({parent, end, -1});
      equations.push_back(1 + any(6));
      for (int i = 0; i < equations.back(); ++i) add({child, {parent, end}}, -kNoEnd, kNoEnd, -1);
    }
    const int firstContact = static_cast<int>(rows.size());
    for (int i = 0; i < contacts; ++i) add({-1, {any(bodies), i % 3 == 0 ? any(bodies) : -1}}, 0, kNoEnd, -1);
    unfrictional = static_cast<int>(rows.size());
    for (int i = 0; i < 2 * contacts; ++i) {
      add({-1, rows[static_cast<std::size_t>(firstContact + i / 2)].bodies}, -0.5, 0.5, i / 2);
    }
    J.resize(rows.size() * motions());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (const int body : rows[i].bodies) {
        for (std::size_t k = 0; body >= 0 && k < 6; ++k)
          J[i * motions() + static_cast<std::size_t>(6 * body) + k] = normal(random);
      }
      b.push_back(normal(random));
      b2.push_back(static_cast<int>(i) < unfrictional ? normal(random) : 0);
    }
    order.find(joints);
  }

  void add(Row row, double low, double high, int normal) {
    if (row.joint < 0) {
      lowest.push_back(low);
      highest.push_back(high);
      normalOf.push_back(normal);
    }
    rows.push_back(std::move(row));
  }
  std::size_t motions() const { return static_cast<std::size_t>(6 * bodies); }
  int bounded() const { return static_cast<int>(lowest.size()); }
  std::size_t firstBounded() const { return rows.size() - lowest.size(); }
  double A(std::size_t i, std::size_t j) const {
    double sum = i == j ? 1e-2 : 0;
    for (std::size_t k = 0; k < motions(); ++k) sum += J[i * motions() + k] * J[j * motions() + k];
    return sum;
  }

  /// Writes the problem to the matrix.
  /// @return Whether it takes it, and where x has each row.
  std::pair<bool, std::vector<int>> writeTo(BlockMatrix& matrix) const {
    std::vector<BlockMatrix::BoundedEnd> ends;
    for (std::size_t i = firstBounded(); i < rows.size(); ++i) {
      for (const int body : rows[i].bodies) {
        if (body >= 0) ends.push_back({static_cast<int>(i - firstBounded()), body});
      }
    }
    if (!matrix.begin(order, equations, bounded(), ends)) return {false, {}};
    std::vector<std::pair<int, int>> places;
    int number = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const int joint = rows[i].joint;
      number = i > 0 && joint >= 0 && joint == rows[i - 1].joint ? number + 1 : 0;
      places.emplace_back(joint < 0 ? matrix.boundedPlace() : order.placeOf(joint),
                          joint < 0 ? matrix.boundedNumber(static_cast<int>(i - firstBounded())) : number);
    }
    std::vector<int> indices;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < rows.size(); ++j) {
        const double value = A(i, j);
        if (value == 0 || places[i] > places[j]) continue;
        const BlockMatrix::Block block = matrix.block(places[i].first, places[j].first);
        block.data[static_cast<std::size_t>(places[i].second) * block.stride +
                  static_cast<std::size_t>(places[j].second)] = value;
      }
      double* const sides = matrix.sides(places[i].first, places[i].second);
      sides[0] = b[i];
      sides[1] = b2[i];
      indices.push_back(matrix.indexOf(places[i].first, places[i].second));
    }
    return {true, indices};
  }

  int bodies;
  std::vector<JointBodies> joints;
  std::vector<int> equations;
  JointOrder order;
  std::vector<Row> rows;
  int unfrictional = 0;
  std::vector<double> J, b, b2;
  /// Of rows with bounds.
  std::vector<double> lowest, highest;
  std::vector<int> normalOf;
};

}  // namespace pongsim::test
