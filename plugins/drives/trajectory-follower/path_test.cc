#include "path.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace pongsim::path_test {
namespace {

Element element(const std::string& name, const std::string& text, std::vector<Element> children = {}) {
  Element result;
  result.name = name;
  result.text = text;
  result.children = std::move(children);
  return result;
}

std::vector<Vector3> pointsOf(std::vector<Element> children) {
  Diagnostics diagnostics;
  const Path path = Path::read(element("plugin", "", std::move(children)), diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
  return path.points({{1, 2, 3}, fromRollPitchYaw(0, 0, M_PI / 2)});
}

std::string refusalOf(std::vector<Element> children) {
  Diagnostics diagnostics;
  try {
    Path::read(element("plugin", "", std::move(children)), diagnostics);
  } catch (const Error& error) {
    return error.diagnostic().message;
  }
  return {};
}

TEST(Path, GoesByWaypointsOfTheWorld) {
  const auto points =
      pointsOf({element("waypoints", "", {element("waypoint", "25 0"), element("waypoint", " -1.5\t2 ")})});
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0], Vector3(25, 0, 0));
  EXPECT_EQ(points[1], Vector3(-1.5, 2, 0));
}

TEST(Path, GoesAroundTheStartInEightPoints) {
  const auto points = pointsOf({element("circle", "", {element("radius", "2")})});
  ASSERT_EQ(points.size(), 8U);
  EXPECT_NEAR((points[0] - Vector3(3, 2, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((points[2] - Vector3(1, 4, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((points[5] - Vector3(1 - std::sqrt(2), 2 - std::sqrt(2), 0)).norm(), 0, 1e-12);
}

TEST(Path, GoesAlongALineSeenFromTheLink) {
  const auto points = pointsOf({element("line", "", {element("direction", "0.5"), element("length", "4")})});
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0], Vector3(1, 2, 0));
  EXPECT_NEAR((points[1] - Vector3(1 - 4 * std::sin(0.5), 2 + 4 * std::cos(0.5), 0)).norm(), 0, 1e-12);
}

TEST(Path, IsTheFirstOfSeveral) {
  Diagnostics diagnostics;
  const Path path = Path::read(element("plugin", "",
                                       {element("line", "", {element("direction", "0"), element("length", "4")}),
                                        element("circle", "", {element("radius", "2")})}),
                               diagnostics);
  EXPECT_EQ(path.points({}).size(), 8U);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message, "<line> has no effect: the path is that of <circle>");
}

TEST(Path, TakesTwoNumbersOfAWaypoint) {
  Diagnostics diagnostics;
  Path::read(element("plugin", "", {element("waypoints", "", {element("waypoint", "1 2 3")})}), diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message, "of <waypoint> '1 2 3' the first two numbers are used, x and y");
}

TEST(Path, MustLeadSomewhere) {
  EXPECT_EQ(refusalOf({}), "no path is given");
  EXPECT_EQ(refusalOf({element("waypoints", "")}), "<waypoints> has no <waypoint>");
  EXPECT_EQ(refusalOf({element("waypoints", "", {element("waypoint", "1")})}),
            "<waypoint> is '1', which is not two finite numbers");
  EXPECT_EQ(refusalOf({element("waypoints", "", {element("waypoint", "1 inf")})}),
            "<waypoint> is '1 inf', which is not two finite numbers");
  EXPECT_EQ(refusalOf({element("waypoints", "", {element("waypoint", "1 east")})}),
            "<waypoint> is 'east', which is not a number");
  EXPECT_EQ(refusalOf({element("circle", "")}), "no <radius> is given");
  EXPECT_EQ(refusalOf({element("circle", "", {element("radius", "nan")})}), "<radius> must be a finite number");
  EXPECT_EQ(refusalOf({element("line", "", {element("length", "1")})}), "no <direction> is given");
  EXPECT_EQ(refusalOf({element("line", "", {element("direction", "1")})}), "no <length> is given");
}

}  // namespace
}  // namespace pongsim::path_test
