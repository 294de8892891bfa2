#include "physics/hulls/decomposition.hh"

#include <gtest/gtest.h>

#include <random>

#include "physics/hulls/hull.hh"
#include "sdf/readers/shapes/extrusion.hh"
#include "support/solids.hh"

namespace pongsim::physics {
namespace {

using test::boxBetween;

std::vector<PieceCorners> piecesOf(const description::TriangleMesh& mesh, std::size_t most = 64,
                                   double standOff = 0.005) {
  return decompose(makeChain(mesh, {1, 1, 1}, true), {most, standOff}).pieces;
}

double volumeOf(const std::vector<PieceCorners>& pieces) {
  double sum = 0;
  for (const PieceCorners& piece : pieces) sum += convexHull(piece).volume;
  return sum;
}

// whether a point lies in one of the pieces
bool holds(const std::vector<PieceCorners>& pieces, const Vector3& point) {
  for (const PieceCorners& piece : pieces) {
    PieceCorners more = piece;
    more.push_back(point);
    if (convexHull(more).volume <= convexHull(piece).volume * (1 + 1e-9)) return true;
  }
  return false;
}

TEST(Decomposition, LeavesWhatIsConvexInOnePiece) {
  EXPECT_EQ(piecesOf(boxBetween({0, 0, 0}, {1, 2, 3})).size(), 1U);
  EXPECT_EQ(piecesOf(test::turned({{0, -1}, {1, -1}, {1, 1}, {0, 1}}, 48)).size(), 1U);
  std::vector<std::pair<double, double>> arc;
  for (int i = 0; i <= 30; ++i) arc.emplace_back(std::sin(M_PI * i / 30), -std::cos(M_PI * i / 30));
  EXPECT_EQ(piecesOf(test::turned(arc, 60)).size(), 1U);
  // of two boxes side by side
  description::TriangleMesh two = boxBetween({0, 0, 0}, {1, 1, 1});
  test::append(boxBetween({1, 0, 0}, {2, 1, 1}), two);
  EXPECT_EQ(piecesOf(two).size(), 1U);
  // a dent of less than a hundredth
  description::TriangleMesh dented = boxBetween({0, 0, 0}, {1, 1, 1});
  dented.vertices.emplace_back(0.5, 0.5, 0.98);
  dented.triangles.erase(dented.triangles.begin() + 2, dented.triangles.begin() + 4);
  for (const auto& [a, b] : {std::pair(4U, 5U), std::pair(5U, 7U), std::pair(7U, 6U), std::pair(6U, 4U)}) {
    dented.triangles.push_back({a, b, 8});
  }
  EXPECT_EQ(piecesOf(dented).size(), 1U);
  EXPECT_TRUE(decompose(TriangleChain(), {}).pieces.empty());
}

TEST(Decomposition, CutsAnglesExactly) {
  const std::vector<PieceCorners> iron = piecesOf(test::angleIron(1, 1));
  EXPECT_EQ(iron.size(), 2U);
  EXPECT_NEAR(volumeOf(iron), 4, 1e-9);
  EXPECT_TRUE(holds(iron, {2.9, 0, 0.5}));
  EXPECT_FALSE(holds(iron, {1.1, 0, 1.1}));

  const sdf::Outline u{{{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}};
  EXPECT_EQ(piecesOf(*sdf::extrude(u, 1)).size(), 3U);
  EXPECT_NEAR(volumeOf(piecesOf(*sdf::extrude(u, 1))), 8, 1e-9);

  const sdf::Outline frame{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
  EXPECT_EQ(piecesOf(*sdf::extrude(frame, 1)).size(), 4U);
  EXPECT_NEAR(volumeOf(piecesOf(*sdf::extrude(frame, 1))), 8, 1e-9);

  description::TriangleMesh hollow = boxBetween({0, 0, 0}, {3, 3, 3});
  test::append(test::turnedInsideOut(boxBetween({1, 1, 1}, {2, 2, 2})), hollow);
  EXPECT_EQ(piecesOf(hollow).size(), 6U);
  EXPECT_NEAR(volumeOf(piecesOf(hollow)), 26, 1e-9);
}

TEST(Decomposition, TakesPartsThatCrossOneByOne) {
  description::TriangleMesh cross = boxBetween({-3, -0.5, -0.5}, {3, 0.5, 0.5});
  test::append(boxBetween({-0.5, -3, -0.4}, {0.5, 3, 0.4}), cross);
  EXPECT_EQ(piecesOf(cross).size(), 2U);
  EXPECT_NEAR(volumeOf(piecesOf(cross)), 6 + 4.8, 1e-9);
}

TEST(Decomposition, FollowsWhatIsRound) {
  // stands out of the mesh by so much on average, in metres, of 0.2
  const description::TriangleMesh bowl = test::bowl(0.2, 0.01, 48, 16);
  const double volume = physics::volumeOf(makeChain(bowl, {1, 1, 1}, false));
  const double surface = 2 * M_PI * 0.2 * 0.2;
  EXPECT_LT((volumeOf(piecesOf(bowl, 64)) - volume) / surface, 0.005);
  EXPECT_LT((volumeOf(piecesOf(bowl, 16)) - volume) / surface, 0.015);
  EXPECT_FALSE(holds(piecesOf(bowl), {0, 0, -0.15}));
  const description::TriangleMesh ring = test::turned({{0.8, 0}, {1, 0}, {1, 0.3}, {0.8, 0.3}}, 64);
  EXPECT_LT(volumeOf(piecesOf(ring)), 1.06 * physics::volumeOf(makeChain(ring, {1, 1, 1}, false)));
  EXPECT_FALSE(holds(piecesOf(ring), {0, 0, 0.15}));
}

TEST(Decomposition, HasNoMorePiecesThanMayBe) {
  for (const std::size_t most : {1U, 2U, 5U, 16U}) {
    EXPECT_LE(piecesOf(test::bowl(0.2, 0.01, 32, 8), most, 0).size(), most);
    // also of many parts that are far from each other
    description::TriangleMesh dust;
    for (int i = 0; i < 200; ++i) {
      const Vector3 at(i % 10, i / 10 % 10, i / 100);
      test::append(boxBetween(at, at + Vector3(0.2, 0.2, 0.2)), dust);
    }
    EXPECT_LE(piecesOf(dust, most).size(), most);
  }
}

TEST(Decomposition, HoldsAllPointsOfTheMesh) {
  const description::TriangleMesh wheel = test::spokedWheel(0.3, 0.05, 48, 6);
  const std::vector<PieceCorners> pieces = piecesOf(wheel);
  for (const Vector3& vertex : wheel.vertices) EXPECT_TRUE(holds(pieces, vertex)) << vertex.transpose();
  // between the spokes there is nothing
  const double between = M_PI / 6;
  EXPECT_FALSE(holds(pieces, {0.2 * std::cos(between), 0, -0.2 * std::sin(between)}));
}

TEST(Decomposition, OfASheetIsThin) {
  description::TriangleMesh box = boxBetween({0, 0, 0}, {1, 1, 1});
  box.triangles.resize(10);
  const std::vector<PieceCorners> sides = decompose(makeChain(box, {1, 1, 1}, false), {64, 0.005}).pieces;
  EXPECT_EQ(sides.size(), 5U);
  EXPECT_NEAR(volumeOf(sides), 0, 1e-6);
}

TEST(Decomposition, GivesTheSameBitsEachTime) {
  const description::TriangleMesh bowl = test::bowl(0.2, 0.01, 32, 10);
  EXPECT_EQ(piecesOf(bowl), piecesOf(bowl));
}

TEST(Decomposition, EndsWithAnything) {
  // triangles anywhere, points twice, flat and thin ones
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-1, 1);
  for (int round = 0; round < 30; ++round) {
    description::TriangleMesh soup;
    const auto count = static_cast<std::uint32_t>(3 + round);
    for (std::uint32_t i = 0; i < count; ++i) {
      soup.vertices.emplace_back(place(random), place(random),
                                 round % 3 == 0 ? 0 : place(random) * (round % 5 == 0 ? 1e-9 : 1));
    }
    std::uniform_int_distribution<std::uint32_t> corner(0, count - 1);
    for (int i = 0; i < 4 * round + 1; ++i) soup.triangles.push_back({corner(random), corner(random), corner(random)});
    for (const bool closesAll : {false, true}) {
      const std::vector<PieceCorners> pieces = decompose(makeChain(soup, {1, 1, 1}, closesAll), {16, 0.005}).pieces;
      EXPECT_LE(pieces.size(), 16U);
      for (const PieceCorners& piece : pieces) {
        EXPECT_FALSE(piece.empty());
        for (const Vector3& point : piece) EXPECT_LE(point.cwiseAbs().maxCoeff(), 1 + 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace pongsim::physics
