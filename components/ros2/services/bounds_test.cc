#include "ros2/services/bounds.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ros2/services/result.hh"
#include "support/running_world.hh"

namespace pongsim::ros2::bounds_test {
namespace {

namespace si = simulation_interfaces;
using si::Bounds;
using test::RunningWorld;

std::string model(const std::string& name, const std::string& pose, const std::string& content) {
  return "<model name='" + name + "'><static>true</static><pose>" + pose + "</pose>" + content + "</model>";
}
std::string collision(const std::string& pose, const std::string& shape) {
  return "<link name='l'><collision name='c'><pose>" + pose + "</pose><geometry>" + shape +
         "</geometry></collision></link>";
}
const std::string kBox = "<box><size>2 4 6</size></box>";
/// A prism of 2 x 2 x 2 m with a notch, an L seen from above: a mesh that is not convex.
const std::string kPolyline =
    "<polyline><point>0 0</point><point>2 0</point><point>2 1</point><point>1 1</point><point>1 2</point>"
    "<point>0 2</point><height>2</height></polyline>";

Bounds boundsWith(std::uint8_t type, const std::vector<Vector3>& points) {
  Bounds bounds;
  bounds.type = type;
  for (const Vector3& point : points) copyVector(point, bounds.points.emplace_back());
  return bounds;
}
Bounds boxFrom(const Vector3& lower, const Vector3& upper) { return boundsWith(Bounds::kTypeBox, {upper, lower}); }
Bounds sphere(const Vector3& center, double radius) {
  return boundsWith(Bounds::kTypeSphere, {center, {radius, 0, 0}});
}

void expectBox(const Bounds& bounds, const Vector3& lower, const Vector3& upper) {
  ASSERT_EQ(bounds.type, Bounds::kTypeBox);
  ASSERT_EQ(bounds.points.size(), 2U);
  EXPECT_TRUE(vectorOf(bounds.points[0]).isApprox(upper, 1e-9)) << vectorOf(bounds.points[0]).transpose();
  EXPECT_TRUE(vectorOf(bounds.points[1]).isApprox(lower, 1e-9)) << vectorOf(bounds.points[1]).transpose();
}

TEST(BoundsOf, AreInTheFrameOfTheCanonicalLink) {
  RunningWorld world(model("m", "10 20 30 0 0 1",
                           "<link name='base'><pose>0 0 1 0 0 0</pose></link>"
                           "<link name='l'><pose>0 0 3 0 0 0</pose><collision name='c'><geometry>" +
                               kBox + "</geometry></collision></link>"));
  Outcome<Bounds> bounds = boundsOf(world.model("m"));
  ASSERT_TRUE(bounds);
  expectBox(*bounds, {-1, -2, -1}, {1, 2, 5});
}

TEST(BoundsOf, TakeInAllShapesAndNestedModels) {
  RunningWorld world(model("m", "0 0 0 0 0 0",
                           collision("0 0 0 0 0 1.5707963267948966", kBox) +
                               "<model name='n'><pose>5 0 0 0 0 0</pose>" +
                               collision("0 0 0 0 0 0", "<sphere><radius>1</radius></sphere>") + "</model>") +
                     model("p", "0 0 0 0 0 0", collision("1 1 1 0 0 0", kPolyline)));
  Outcome<Bounds> bounds = boundsOf(world.model("m"));
  ASSERT_TRUE(bounds);
  expectBox(*bounds, {-2, -1, -3}, {6, 1, 3});
  Outcome<Bounds> mesh = boundsOf(world.model("p"));
  ASSERT_TRUE(mesh);
  const Vector3 size = vectorOf(mesh->points[0]) - vectorOf(mesh->points[1]);
  EXPECT_TRUE(size.isApprox(Vector3(2, 2, 2), 1e-6)) << size.transpose();
}

TEST(BoundsOf, AreEmptyWhereThereIsNoEndAndAnErrorWhereThereIsNothing) {
  RunningWorld world(model("plane", "0 0 0 0 0 0", collision("0 0 0 0 0 0", "<plane/>")) +
                     model("ghost", "0 0 0 0 0 0", "<link name='l'/>"));
  Outcome<Bounds> plane = boundsOf(world.model("plane"));
  ASSERT_TRUE(plane);
  EXPECT_EQ(*plane, Bounds());
  EXPECT_EQ(boundsOf(world.model("ghost")).error, "'ghost' has no collision to compute its bounds from");
}

class RegionTest : public testing::Test {
 protected:
  static bool overlaps(const Bounds& bounds, const Model& model) {
    Outcome<Region> region = Region::from(bounds);
    EXPECT_TRUE(region) << region.error;
    return region && region->overlaps(model);
  }
  RunningWorld world_{
      model("box", "10 0 0 0 0 0.7853981633974483", collision("0 0 0 0 0 0", "<box><size>2 2 2</size></box>")) +
      model("ground", "0 0 -5 0 0 0", collision("0 0 0 0 0 0", "<plane/>")) +
      model("ghost", "0 8 0 0 0 0", "<link name='l'/>") +
      model("mesh", "-10 0 0 0 0 0", collision("0 0 0 0 0 0", kPolyline))};
};

TEST_F(RegionTest, ABoxASphereAndAHullOverlapWhatTheyReach) {
  const Model box = world_.model("box");
  EXPECT_TRUE(overlaps(boxFrom({8, -0.1, 0}, {8.7, 0.1, 0.5}), box));
  // beside the edge, but within the box's own bounds
  EXPECT_FALSE(overlaps(boxFrom({8.6, 0.9, 0}, {9, 1.2, 0.5}), box));
  EXPECT_TRUE(overlaps(sphere({8, 0, 0}, 0.6), box));
  EXPECT_FALSE(overlaps(sphere({8, 0, 0}, 0.5), box));
  EXPECT_TRUE(overlaps(boundsWith(Bounds::kTypeConvexHull, {{8, 0, 0}, {8, 1, 0}, {8.7, 0, 0}}), box));
  EXPECT_FALSE(overlaps(boundsWith(Bounds::kTypeConvexHull, {{8, 0, 0}, {8, 1, 0}, {8.5, 0, 0}, {8, 0, 9}}), box));
}

TEST_F(RegionTest, APlaneHasAllBelowIt) {
  EXPECT_TRUE(overlaps(sphere({0, 0, -4}, 1.1), world_.model("ground")));
  EXPECT_TRUE(overlaps(sphere({0, 0, -40}, 1), world_.model("ground")));
  EXPECT_FALSE(overlaps(sphere({0, 0, -4}, 0.9), world_.model("ground")));
}

TEST_F(RegionTest, AMeshIsItsSurfaceAndWhatThatEncloses) {
  const Outcome<Bounds> found = boundsOf(world_.model("mesh"));
  const Vector3 lower = vectorOf(found.value.value().points[1]) + Vector3(-10, 0, 0);
  const auto there = [&](double x, double y, double z) { return Vector3(lower + Vector3(x, y, z)); };
  EXPECT_TRUE(overlaps(sphere(there(1, 0.5, 1), 0.6), world_.model("mesh")));
  // inside, without touching a triangle
  EXPECT_TRUE(overlaps(sphere(there(0.5, 0.5, 1), 0.1), world_.model("mesh")));
  // in the notch
  EXPECT_FALSE(overlaps(sphere(there(1.6, 1.6, 1), 0.3), world_.model("mesh")));
  EXPECT_FALSE(overlaps(sphere(there(-1, 0.5, 1), 0.9), world_.model("mesh")));
}

TEST_F(RegionTest, WhatHasNoCollisionIsWhereItsOriginIs) {
  EXPECT_TRUE(overlaps(sphere({0, 8.5, 0}, 0.6), world_.model("ghost")));
  EXPECT_FALSE(overlaps(sphere({0, 8.5, 0}, 0.4), world_.model("ghost")));
}

TEST_F(RegionTest, SaysWhatIsWrongWithBounds) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto errorOf = [](const Bounds& bounds) { return Region::from(bounds).error; };
  EXPECT_EQ(errorOf(sphere({kNan, 0, 0}, 1)), "a point of the bounds is not finite");
  EXPECT_EQ(errorOf(sphere({0, 0, 0}, 0)), "the sphere's radius, x of the second point, is not above 0");
  EXPECT_EQ(errorOf(boxFrom({1, 0, 0}, {0, 1, 1})),
            "the first point of the box must be its upper corner, the second its lower");
  EXPECT_EQ(errorOf(boundsWith(Bounds::kTypeBox, {{1, 1, 1}})), "bounds that are a box have two points, not 1");
  EXPECT_EQ(errorOf(boundsWith(Bounds::kTypeSphere, {})), "bounds that are a sphere have two points, not 0");
  EXPECT_EQ(errorOf(boundsWith(Bounds::kTypeConvexHull, {{1, 1, 1}, {0, 0, 0}})),
            "a convex hull needs at least 3 points");
  EXPECT_EQ(errorOf(boundsWith(Bounds::kTypeConvexHull, {{1, 1, 1}, {0, 0, 0}, {2, 2, 2}})),
            "the points of the convex hull lie on a line");
}

}  // namespace
}  // namespace pongsim::ros2::bounds_test
