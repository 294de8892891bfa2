#include "physics/hulls/triangle_chain.hh"

#include <gtest/gtest.h>

#include <numbers>

#include "physics/hulls/chain_edges.hh"
#include "support/solids.hh"

namespace pongsim::physics {
namespace {

using test::boxBetween;

constexpr double kTolerance = 1e-9;

TriangleChain chainOf(const description::TriangleMesh& mesh, bool closesAll = false) {
  return makeChain(mesh, {1, 1, 1}, closesAll);
}

TEST(TriangleChain, MakesOneOfPointsInTheSamePlace) {
  // as STL has it: three vertices a triangle
  const description::TriangleMesh box = boxBetween({0, 0, 0}, {1, 2, 3});
  description::TriangleMesh soup;
  for (const auto& [a, b, c] : box.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t corner : {a, b, c}) soup.vertices.push_back(box.vertices[corner]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const TriangleChain chain = chainOf(soup);
  EXPECT_EQ(chain.points.size(), 8U);
  EXPECT_TRUE(chain.isClosed);
  EXPECT_NEAR(volumeOf(chain), 6, kTolerance);
}

TEST(TriangleChain, IsScaledAndMirrored) {
  const TriangleChain chain = makeChain(boxBetween({0, 0, 0}, {1, 2, 3}), {1, -2, 0.5}, false);
  EXPECT_TRUE(chain.isClosed);
  EXPECT_NEAR(volumeOf(chain), 6, kTolerance);
}

TEST(TriangleChain, LeavesOutWhatHasNoArea) {
  description::TriangleMesh mesh = boxBetween({0, 0, 0}, {1, 1, 1});
  mesh.triangles.push_back({0, 0, 1});
  mesh.vertices.emplace_back(0.5, 0, 0);
  mesh.triangles.push_back({0, 8, 1});
  EXPECT_EQ(chainOf(mesh).triangles.size(), 12U);
  mesh.triangles = {{1, 1, 1}};
  EXPECT_TRUE(chainOf(mesh).triangles.empty());
  EXPECT_FALSE(chainOf(mesh).isClosed);
  EXPECT_TRUE(chainOf({}).triangles.empty());
}

TEST(TriangleChain, ClosesSmallHolesAndLargeOnesIfAsked) {
  // a fine ball without one triangle, and a box without one side
  description::TriangleMesh ball = test::turned({{0, -1}, {0.7, -0.7}, {1, 0}, {0.7, 0.7}, {0, 1}}, 24);
  ball.triangles.erase(ball.triangles.begin() + 50);
  EXPECT_TRUE(chainOf(ball).isClosed);
  description::TriangleMesh box = boxBetween({0, 0, 0}, {1, 1, 1});
  box.triangles.resize(10);
  EXPECT_FALSE(chainOf(box).isClosed);
  EXPECT_EQ(volumeOf(chainOf(box)), 0);
  EXPECT_TRUE(chainOf(box, true).isClosed);
  EXPECT_NEAR(std::abs(volumeOf(chainOf(box, true))), 1, kTolerance);
}

TEST(TriangleChain, SeesABodyInWhatShowsBothSidesOrAnyOne) {
  description::TriangleMesh twice = boxBetween({0, 0, 0}, {1, 1, 1});
  test::append(test::turnedInsideOut(twice), twice);
  EXPECT_TRUE(chainOf(twice).isClosed);
  EXPECT_NEAR(std::abs(volumeOf(chainOf(twice))), 1, kTolerance);
  description::TriangleMesh mixed = boxBetween({0, 0, 0}, {1, 1, 1});
  for (std::size_t i = 0; i < 12; i += 3) std::swap(mixed.triangles[i][1], mixed.triangles[i][2]);
  EXPECT_TRUE(chainOf(mixed).isClosed);
  EXPECT_NEAR(std::abs(volumeOf(chainOf(mixed))), 1, kTolerance);
  // a sheet has no inside, filled or not
  description::TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_FALSE(chainOf(sheet, true).isClosed);
}

TEST(TriangleChain, SeparatesBodiesAndKeepsTheirCavities) {
  description::TriangleMesh mesh = boxBetween({0, 0, 0}, {3, 3, 3});
  test::append(test::turnedInsideOut(boxBetween({1, 1, 1}, {2, 2, 2})), mesh);
  test::append(boxBetween({5, 0, 0}, {6, 1, 1}), mesh);
  // its own box holds no other: it is inside out by mistake
  test::append(test::turnedInsideOut(boxBetween({8, 0, 0}, {10, 1, 1})), mesh);
  const std::vector<TriangleChain> bodies = separateBodies(chainOf(mesh));
  ASSERT_EQ(bodies.size(), 3U);
  EXPECT_NEAR(volumeOf(bodies[0]), 26, kTolerance);
  EXPECT_NEAR(volumeOf(bodies[1]), 1, kTolerance);
  EXPECT_NEAR(volumeOf(bodies[2]), 2, kTolerance);
}

// both halves of a cut, which are closed and fill what was there
void expectCut(const TriangleChain& chain, const Plane& plane, double front, double back) {
  const Halves halves = cut(chain, plane, 1e-7, true);
  EXPECT_TRUE(boundaryOf(halves.front.triangles).empty());
  EXPECT_TRUE(boundaryOf(halves.back.triangles).empty());
  EXPECT_NEAR(volumeOf(halves.front), front, kTolerance);
  EXPECT_NEAR(volumeOf(halves.back), back, kTolerance);
}

TEST(TriangleChain, IsCutInTwoClosedHalves) {
  const TriangleChain box = chainOf(boxBetween({0, 0, 0}, {1, 2, 3}));
  expectCut(box, {Vector3::UnitZ(), 1}, 4, 2);
  expectCut(box, {-Vector3::UnitZ(), -1}, 2, 4);
  expectCut(box, {Vector3(1, 2, 0).normalized(), 2.5 / std::sqrt(5.0)}, 3, 3);
  // along a side: nothing lies behind it
  expectCut(box, {Vector3::UnitX(), 0}, 6, 0);
}

TEST(TriangleChain, IsCutThroughHolesAndAlongFaces) {
  description::TriangleMesh hollow = boxBetween({0, 0, 0}, {3, 3, 3});
  test::append(test::turnedInsideOut(boxBetween({1, 1, 1}, {2, 2, 2})), hollow);
  const TriangleChain chain = chainOf(hollow);
  expectCut(chain, {Vector3::UnitZ(), 1.5}, 13, 13);
  expectCut(chain, {Vector3::UnitZ(), 1}, 17, 9);
  expectCut(chain, {Vector3::UnitX(), 2}, 9, 17);
  // what closes a cut does not go over the hole
  for (const TriangleChain& half : {cut(chain, {Vector3::UnitZ(), 1.5}, 1e-7, true).front}) {
    for (const TriangleChain::Triangle& t : half.triangles) {
      const Vector3 middle = (half.points[t.a] + half.points[t.b] + half.points[t.c]) / 3;
      const bool isInHole = (middle - Vector3::Constant(1.5)).cwiseAbs().maxCoeff() < 0.5 - 1e-9;
      EXPECT_FALSE(t.isCap && isInHole) << middle.transpose();
    }
  }
  const TriangleChain bowl = chainOf(test::bowl(0.2, 0.02, 40, 12));
  const double volume = volumeOf(bowl);
  expectCut(bowl, {Vector3::UnitX(), 0}, volume / 2, volume / 2);
  const Halves rings = cut(bowl, {Vector3::UnitZ(), -0.07}, 1e-7, true);
  EXPECT_TRUE(boundaryOf(rings.front.triangles).empty());
  EXPECT_NEAR(volumeOf(rings.front) + volumeOf(rings.back), volume, kTolerance);
}

TEST(TriangleChain, IsCutOverAndOver) {
  // pieces of pieces stay closed, and nothing is lost
  std::vector<TriangleChain> pieces{chainOf(test::spokedWheel(0.3, 0.1, 32, 5))};
  const double volume = volumeOf(pieces[0]);
  for (int i = 0; i < 6; ++i) {
    const Vector3 normal = Vector3(std::sin(2.0 * i), std::cos(3.0 * i), std::sin(5.0 * i + 1)).normalized();
    std::vector<TriangleChain> next;
    for (const TriangleChain& piece : pieces) {
      Halves halves = cut(piece, {normal, 0.02 * i}, 1e-7, true);
      for (TriangleChain* half : {&halves.front, &halves.back}) {
        EXPECT_TRUE(boundaryOf(half->triangles).empty());
        if (!half->triangles.empty()) next.push_back(std::move(*half));
      }
    }
    pieces = std::move(next);
  }
  double sum = 0;
  for (const TriangleChain& piece : pieces) sum += volumeOf(piece);
  EXPECT_GT(pieces.size(), 15U);
  EXPECT_NEAR(sum, volume, 1e-6 * volume);
}

TEST(TriangleChain, OfASheetStaysOpenWhenCut) {
  description::TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Halves halves = cut(chainOf(sheet), {Vector3::UnitX(), 1}, 1e-7, true);
  EXPECT_FALSE(halves.front.isClosed);
  EXPECT_FALSE(halves.front.triangles.empty());
  for (const Vector3& point : halves.front.points) EXPECT_GE(point.x(), 1 - 1e-9);
}

TEST(TriangleChain, GetsCoarserAndStaysClosed) {
  TriangleChain chain = chainOf(test::bowl(0.2, 0.02, 200, 80));
  ASSERT_GT(chain.triangles.size(), 50'000U);
  const double volume = volumeOf(chain);
  coarsen(chain, 5000);
  EXPECT_LE(chain.triangles.size(), 5000U);
  EXPECT_GT(chain.triangles.size(), 1000U);
  EXPECT_TRUE(boundaryOf(chain.triangles).empty());
  EXPECT_NEAR(volumeOf(chain), volume, 0.1 * volume);
  TriangleChain small = chainOf(boxBetween({0, 0, 0}, {1, 1, 1}));
  coarsen(small, 5000);
  EXPECT_EQ(small.triangles.size(), 12U);
}

}  // namespace
}  // namespace pongsim::physics
