#include "pongsim/sensing/environment.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::environment_test {
namespace {

using std::chrono::milliseconds;
using Reference = EnvironmentSettings::Reference;

Environment environmentOf(const std::string& csv, const EnvironmentSettings& settings = {}) {
  Outcome<Environment> read = Environment::fromCsv(csv, settings);
  EXPECT_TRUE(read) << read.error;
  return std::move(*read);
}

double planeAt(const Vector3& place) { return 1 + 2 * place.x() - 3 * place.y() + 0.5 * place.z(); }

/// A grid with uneven distances, in which `h` is that of a plane; 10 s later it is twice as much.
std::string plane() {
  std::ostringstream text;
  text << "t,x,y,z,zero,h\n";
  for (const int time : {0, 10}) {
    for (const double x : {-5.0, 0.0, 0.5, 100.0}) {
      for (const double y : {1.0, 2.0, 8.0}) {
        for (const double z : {-1.0, 3.0}) {
          text << time << ',' << x << ',' << y << ',' << z << ",0," << planeAt({x, y, z}) * (time == 0 ? 1 : 2) << '\n';
        }
      }
    }
  }
  return text.str();
}

TEST(Environment, InterpolatesLinearFunctionsExactly) {
  const Environment environment = environmentOf(plane());
  EXPECT_EQ(environment.quantities(), (std::vector<std::string>{"zero", "h"}));
  EXPECT_EQ(environment.missingPoints(), 0U);
  const std::size_t h = environment.quantity("h").value();
  for (const Vector3& place : {Vector3(-5, 1, -1), Vector3(100, 8, 3), Vector3(0.25, 1.3, 2.9), Vector3(0, 2, 3),
                               Vector3(70, 7.5, -0.9), Vector3(0.5, 1.5, -1)}) {
    EXPECT_NEAR(environment.at(h, milliseconds(0), place).value(), planeAt(place), 1e-9) << place.transpose();
    EXPECT_NEAR(environment.at(h, milliseconds(2500), place).value(), 1.25 * planeAt(place), 1e-9);
    EXPECT_NEAR(environment.at(h, milliseconds(10000), place).value(), 2 * planeAt(place), 1e-9);
    EXPECT_EQ(environment.at(0, milliseconds(5), place).value(), 0);
  }
  EXPECT_FALSE(environment.quantity("x"));
  EXPECT_FALSE(environment.quantity(""));
}

TEST(Environment, HasNothingOutside) {
  const Environment environment = environmentOf(plane());
  EXPECT_EQ(environment.times(), std::pair(0.0, 10.0));
  EXPECT_FALSE(environment.at(1, milliseconds(10001), {0, 2, 0}));
  for (const Vector3& place : {Vector3(-5.1, 2, 0), Vector3(101, 2, 0), Vector3(0, 0.9, 0), Vector3(0, 9, 0),
                               Vector3(0, 2, -2), Vector3(0, 2, 3.1), Vector3(std::nan(""), 2, 0)}) {
    EXPECT_FALSE(environment.at(1, milliseconds(0), place)) << place.transpose();
  }
  // as Gazebo's tolerance has it
  EXPECT_NEAR(environment.at(1, milliseconds(0), {-5 - 5e-7, 2, 0}).value(), planeAt({-5, 2, 0}), 1e-9);
}

TEST(Environment, HasGridsOfTheirOwnAtEachTime) {
  const std::string csv =
      "t,x,y,z,h\n0,0,0,0,1\n0,1,0,0,1\n"
      "10,1,0,0,3\n10,2,0,0,3\n";
  const Environment environment = environmentOf(csv);
  EXPECT_DOUBLE_EQ(environment.at(0, milliseconds(5000), {1, 0, 0}).value(), 2);
  EXPECT_DOUBLE_EQ(environment.at(0, milliseconds(5000), {0, 0, 0}).value(), 1);
  EXPECT_DOUBLE_EQ(environment.at(0, milliseconds(5000), {2, 0, 0}).value(), 3);
}

TEST(Environment, CountsMissingPointsAsZeroAndTheLastOfTwoLines) {
  const Environment environment = environmentOf("t,x,y,z,h\n0,0,0,0,9\n0,0,0,0,4\n0,1,1,0,4\n", {.isStatic = true});
  EXPECT_EQ(environment.missingPoints(), 2U);
  EXPECT_DOUBLE_EQ(environment.at(0, milliseconds(0), {0, 0, 0}).value(), 4);
  EXPECT_DOUBLE_EQ(environment.at(0, milliseconds(0), {0.5, 0.5, 0}).value(), 2);
}

TEST(Environment, HoldsItsFirstTimeForEver) {
  const Environment environment = environmentOf(plane(), {.isStatic = true});
  for (const auto time : {milliseconds(0), milliseconds(9000), milliseconds(1'000'000)}) {
    EXPECT_NEAR(environment.at(1, time, {0, 2, 0}).value(), planeAt({0, 2, 0}), 1e-9);
  }
}

/// What `placeOf` makes of a position in a world at a place on the earth.
Vector3 placed(const EnvironmentSettings& settings, const std::string& latitude, const std::string& heading,
               const Vector3& position) {
  test::RunningWorld world("<spherical_coordinates><surface_model>EARTH_WGS84</surface_model><latitude_deg>" +
                           latitude + "</latitude_deg><longitude_deg>0</longitude_deg><elevation>100</elevation>" +
                           "<heading_deg>" + heading + "</heading_deg></spherical_coordinates>");
  const World seen = world.simulation().world();
  return environmentOf("t,x,y,z\n0,0,0,0\n", settings).placeOf(position, seen).value();
}

TEST(Environment, HasItsPlacesOnTheEarth) {
  const EnvironmentSettings global, ecef{.reference = Reference::kEcef},
      degrees{.reference = Reference::kSpherical, .isInDegrees = true}, radians{.reference = Reference::kSpherical};
  EXPECT_TRUE(placed(global, "0", "0", {1, 2, 3}).isApprox(Vector3(1, 2, 3), 1e-12));
  // x to the north, y to the west
  EXPECT_TRUE(placed(global, "0", "90", {1, 2, 3}).isApprox(Vector3(-2, 1, 3), 1e-12));
  // up from the equator, and from the pole: semi-axes of WGS84
  EXPECT_TRUE(placed(ecef, "0", "0", {1, 2, 3}).isApprox(Vector3(6378137 + 103, 1, 2), 1e-12));
  EXPECT_NEAR(placed(ecef, "90", "0", {0, 0, 3}).z(), 6356752.3142 + 103, 1e-3);
  EXPECT_NEAR(placed(degrees, "30", "0", {0, 0, 5}).x(), 30, 1e-9);
  EXPECT_NEAR(placed(degrees, "30", "0", {0, 0, 5}).z(), 105, 1e-6);
  EXPECT_NEAR(placed(radians, "30", "0", {0, 0, 5}).x(), 0.5235987755982988, 1e-12);
}

TEST(Environment, NeedsTheWorldsPlaceOnlyWhereItCounts) {
  test::RunningWorld world(std::string{});
  const World seen = world.simulation().world();
  EXPECT_TRUE(environmentOf("t,x,y,z\n0,0,0,0\n").placeOf({1, 2, 3}, seen).value().isApprox(Vector3(1, 2, 3), 1e-12));
  EXPECT_FALSE(environmentOf("t,x,y,z\n0,0,0,0\n", {.reference = Reference::kSpherical}).placeOf({1, 2, 3}, seen));
}

}  // namespace
}  // namespace pongsim::environment_test
