#include "base/geometry/triangulation.hh"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <utility>

namespace pongsim::base {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

double coveredBy(const Points& points, const Triangles& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    EXPECT_GE(twiceArea(points[a], points[b], points[c]), 0);
    sum += twiceArea(points[a], points[b], points[c]) / 2;
  }
  return sum;
}

// edges that no triangle passes the other way
std::map<std::pair<std::uint32_t, std::uint32_t>, int> boundaryOf(const Triangles& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& [a, b, c] : triangles) {
    for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const std::pair back(edge.second, edge.first);
      if (edges.contains(back)) {
        if (--edges[back] == 0) edges.erase(back);
      } else {
        ++edges[edge];
      }
    }
  }
  return edges;
}

TEST(Triangulation, FillsALineThatIsNotConvex) {
  const Points points{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
  Triangulation triangulation(points);
  triangulation.add({0, 1, 2, 3, 4, 5}, {});
  const Triangles triangles = triangulation.take();
  EXPECT_EQ(triangles.size(), 4U);
  EXPECT_DOUBLE_EQ(coveredBy(points, triangles), 4);
  EXPECT_TRUE(triangulation.isComplete());
}

TEST(Triangulation, LeavesOutHoles) {
  const Points points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 3}, {3, 3}, {3, 1}};
  Triangulation triangulation(points);
  triangulation.add({0, 1, 2, 3}, {{4, 5, 6, 7}});
  EXPECT_DOUBLE_EQ(coveredBy(points, triangulation.take()), 12);
  EXPECT_TRUE(triangulation.isComplete());
}

TEST(Triangulation, HasEachEdgeOfTheLineAlsoWhereItIsStraight) {
  const Points points{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}};
  Triangulation triangulation(points);
  triangulation.add({0, 1, 2, 3, 4, 5}, {});
  const Triangles triangles = triangulation.take();
  EXPECT_DOUBLE_EQ(coveredBy(points, triangles), 4);
  const auto boundary = boundaryOf(triangles);
  EXPECT_EQ(boundary.size(), 6U);
  for (std::uint32_t i = 0; i < 6; ++i) EXPECT_TRUE(boundary.contains({i, (i + 1) % 6})) << i;
}

TEST(Triangulation, SaysWhereAHoleIsOutside) {
  const Points points{{0, 0}, {1, 0}, {0, 1}, {5, 5}, {5, 6}, {6, 5}};
  Triangulation triangulation(points);
  triangulation.add({0, 1, 2}, {{3, 4, 5}});
  EXPECT_FALSE(triangulation.isComplete());
}

TEST(Triangulation, EndsWhateverTheLineIs) {
  const Points points{{0, 0}, {2, 2}, {2, 0}, {0, 2}, {1, 1}, {1, 1}};
  Triangulation triangulation(points);
  triangulation.add({0, 1, 2, 3, 4, 5}, {});
  EXPECT_EQ(triangulation.take().size(), 4U);
}

}  // namespace
}  // namespace pongsim::base
