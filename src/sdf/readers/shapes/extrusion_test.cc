#include "sdf/readers/shapes/extrusion.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <utility>

namespace pongsim::sdf::test {
namespace {

using Line = std::vector<Eigen::Vector2d>;

Line square(double edge, double x = 0, double y = 0) {
  return {{x, y}, {x + edge, y}, {x + edge, y + edge}, {x, y + edge}};
}

Line reversed(Line line) {
  std::reverse(line.begin(), line.end());
  return line;
}

/// Checks that each edge belongs to two triangles that go along it in opposite directions.
/// @return The volume within the surface.
double volumeOf(const description::TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    ++edges[{a, b}];
    ++edges[{b, c}];
    ++edges[{c, a}];
    volume += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6;
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
  return volume;
}

double volumeOf(const Outline& outline, double height) {
  EXPECT_FALSE(crosses(outline));
  return volumeOf(*extrude(outline, height));
}

TEST(Extrusion, FillsWhatALineEncloses) {
  EXPECT_NEAR(volumeOf({square(2)}, 3), 12, 1e-12);
  EXPECT_NEAR(volumeOf({reversed(square(2))}, 3), 12, 1e-12);
  // an L, and a star with flat corners
  EXPECT_NEAR(volumeOf({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}, 1), 3, 1e-12);
  EXPECT_NEAR(volumeOf({{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 0.5}, {0, 2}, {0, 1}}}, 1), 2.5, 1e-12);
}

TEST(Extrusion, StandsOnThePlane) {
  const auto mesh = extrude({square(1, 5, 7)}, 2);
  EXPECT_EQ(mesh->vertices.size(), 8U);
  EXPECT_EQ(mesh->triangles.size(), 12U);
  EXPECT_EQ(mesh->vertices.front(), Vector3(5, 7, 0));
  EXPECT_EQ(mesh->vertices.back(), Vector3(5, 8, 2));
}

TEST(Extrusion, LeavesHolesAndFillsWhatIsInThem) {
  EXPECT_NEAR(volumeOf({square(10), square(2, 1, 1), square(3, 5, 5)}, 1), 100 - 4 - 9, 1e-12);
  EXPECT_NEAR(volumeOf({square(2, 1, 1), reversed(square(10)), square(8, 20, 0)}, 1), 100 - 4 + 64, 1e-12);
  EXPECT_NEAR(volumeOf({square(10), square(8, 1, 1), square(6, 2, 2), square(4, 3, 3)}, 1), 100 - 64 + 36 - 16, 1e-12);
  // holes in a row, at the same height, join across each other
  EXPECT_NEAR(volumeOf({square(10), square(1, 1, 4), square(1, 3, 4), square(1, 5, 4), square(1, 7, 4)}, 1), 96, 1e-12);
}

TEST(Extrusion, CutsWhatIsFarFromConvex) {
  constexpr int kTeeth = 100;
  Line comb{{kTeeth, 0}, {kTeeth, -1}, {0, -1}};
  double area = kTeeth;
  for (int i = 0; i < kTeeth; ++i) {
    comb.emplace_back(i, 0);
    comb.emplace_back(i + 0.5, 1 + i % 7);
    area += (1 + i % 7) * 0.5;
  }
  EXPECT_NEAR(volumeOf({comb}, 1), area, 1e-9);

  // a ring, round outside and inside
  Line outer, inner;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * std::numbers::pi / 180;
    outer.emplace_back(2 * std::cos(angle), 2 * std::sin(angle));
    inner.emplace_back(std::cos(angle), std::sin(angle));
  }
  const double circle = 180 * std::sin(std::numbers::pi / 180);
  EXPECT_NEAR(volumeOf({outer, inner}, 1), 3 * circle, 1e-9);
}

TEST(Extrusion, FillsStarsOfAnyShape) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> radius(0.2, 2);
  for (int round = 0; round < 50; ++round) {
    Line star;
    double area = 0;
    for (int i = 0; i < 60; ++i) {
      const double angle = i * std::numbers::pi / 30;
      star.push_back(radius(random) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    for (std::size_t i = 0; i < star.size(); ++i) {
      const Eigen::Vector2d &a = star[i], &b = star[(i + 1) % star.size()];
      area += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    EXPECT_NEAR(volumeOf({star}, 1), area, 1e-9);
  }
}

TEST(Extrusion, KnowsLinesThatCrossOrTouch) {
  EXPECT_TRUE(crosses({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}));
  EXPECT_TRUE(crosses({square(2), square(2, 1, 1)}));
  EXPECT_TRUE(crosses({square(2), square(1, 0, 0.5)}));
  EXPECT_TRUE(crosses({square(2), square(2)}));
  EXPECT_TRUE(crosses({{{0, 0}, {2, 0}, {1, 0}, {1, 1}}}));
  EXPECT_FALSE(crosses({square(2), square(1, 0.5, 0.5), square(2, 3, 0)}));
  EXPECT_FALSE(crosses({{{0, 0}, {1, 0}, {2, 0}, {1, 1}}}));
}

}  // namespace
}  // namespace pongsim::sdf::test
