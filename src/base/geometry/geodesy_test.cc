#include "pongsim/geometry/geodesy.hh"

#include <gtest/gtest.h>

#include <numbers>

namespace pongsim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kQuarter = std::numbers::pi / 2;

TEST(TangentPlane, HasItsOriginWhereItIs) {
  for (const double latitude : {-89.9, -45.0, 0.0, 30.0, 90.0}) {
    const GeodeticPosition found = TangentPlane({latitude * kDegree, 1, 250}, 0.5).at(Vector3::Zero());
    EXPECT_NEAR(found.latitude, latitude * kDegree, 1e-12);
    EXPECT_NEAR(found.altitude, 250, 1e-6);
    // the pole has all longitudes
    if (latitude < 90) {
      EXPECT_NEAR(found.longitude, 1, 1e-9);
    }
  }
}

// Lengths of a degree on WGS84: 110.574 km along the meridian and 111.320 km along the equator, both at the equator.
TEST(TangentPlane, GoesEastAndNorth) {
  const TangentPlane plane({0, 0, 0}, 0);
  EXPECT_NEAR(plane.at({0, 1105.74, 0}).latitude / kDegree, 0.01, 1e-6);
  EXPECT_NEAR(plane.at({1113.20, 0, 0}).longitude / kDegree, 0.01, 1e-6);
  EXPECT_NEAR(plane.at({0, 0, 7}).altitude, 7, 1e-6);
  // the plane leaves the round earth
  EXPECT_NEAR(plane.at({1000, 0, 0}).altitude, 1000.0 * 1000.0 / (2 * 6378137.0), 1e-4);
}

TEST(TangentPlane, TurnsByItsHeading) {
  const TangentPlane plane({0, 0, 0}, kQuarter);
  // x points north, y west
  EXPECT_NEAR(plane.at({1105.74, 0, 0}).latitude / kDegree, 0.01, 1e-6);
  EXPECT_NEAR(plane.at({0, 1113.20, 0}).longitude / kDegree, -0.01, 1e-6);
}

TEST(TangentPlane, CrossesTheDateLine) {
  const TangentPlane plane({0, 180 * kDegree, 0}, 0);
  EXPECT_NEAR(plane.at({1113.20, 0, 0}).longitude / kDegree, -179.99, 1e-6);
}

TEST(TangentPlane, FindsThePlaceAgain) {
  const TangentPlane plane({0.8, -2, 150}, 0.3);
  for (const Vector3& position : {Vector3(0, 0, 0), Vector3(1200, -50, 10), Vector3(-4e5, 3e5, -200)}) {
    EXPECT_NEAR((plane.positionOf(plane.at(position)) - position).norm(), 0, 1e-6);
  }
}

}  // namespace
}  // namespace pongsim
