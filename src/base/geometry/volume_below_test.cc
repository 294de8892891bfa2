#include "base/geometry/volume_below.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "pongsim/geometry/ball.hh"
#include "pongsim/geometry/prism.hh"

namespace pongsim::base {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Vector3> directions() {
  std::vector<Vector3> all{Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ(), -Vector3::UnitZ()};
  for (const Vector3& each : {Vector3(1, 2, 3), Vector3(-3, 1, -2), Vector3(1, 0, 1e-3), Vector3(1e-3, 1e-3, 1),
                              Vector3(-1, 1, 1e-7), Vector3(1e-7, 0, -1)}) {
    all.push_back(each.normalized());
  }
  return all;
}

/// Counts small cubes: what is right to some hundredths whatever the formula.
VolumeMoments counted(const Vector3& half, const std::function<bool(const Vector3&)>& isInside, const Vector3& up,
                      double height) {
  constexpr int kCells = 30;
  VolumeMoments sum;
  const Vector3 cell = 2 * half / kCells;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      for (int k = 0; k < kCells; ++k) {
        const Vector3 p = cell.cwiseProduct(Vector3(i + 0.5, j + 0.5, k + 0.5)) - half;
        if (!isInside(p) || up.dot(p) > height) continue;
        sum += {cell.prod(), cell.prod() * p};
      }
    }
  }
  return sum;
}

void expectNear(const VolumeMoments& found, const VolumeMoments& expected, double tolerance, const char* what) {
  EXPECT_NEAR(found.volume, expected.volume, tolerance) << what;
  EXPECT_NEAR((found.first - expected.first).norm(), 0, tolerance) << what;
}

TEST(VolumeBelow, OfAHalfBallAndTheOtherHalfMakeThatOfTheBall) {
  for (const Vector3& up : directions()) {
    for (const double height : {-0.69, -0.3, -1e-9, 0.0, 0.2, 0.5, 0.7}) {
      VolumeMoments both = halfBallBelow(0.7, up, height);
      VolumeMoments other = halfBallBelow(0.7, {up.x(), up.y(), -up.z()}, height);
      other.first.z() *= -1;
      both += other;
      expectNear(both, Ball{0.7}.below(up, height), 1e-9, "half balls");
    }
  }
}

// as the ends of a capsule that floats on its side: a hair's turn changes them by no more than that
TEST(VolumeBelow, OfAHalfBallThatLiesNearlyLevelIsThatOfALevelOne) {
  for (int i = 0; i < 100; ++i) {
    const Vector3 level(std::cos(i), std::sin(i), 0);
    for (const double turn : {1e-5, -1e-5, 1e-7, -1e-7, 1e-9, -1e-9}) {
      const Vector3 up = (level + turn * Vector3::UnitZ()).normalized();
      for (const double height : {-0.2, 0.05, 0.2}) {
        expectNear(halfBallBelow(0.3, up, height), halfBallBelow(0.3, level, height), 0.1 * std::abs(turn) + 1e-13,
                   "half ball");
      }
    }
  }
}

TEST(VolumeBelow, IsWhatCountingGives) {
  const double r = 0.7, length = 1.1;
  const auto inHalfBall = [=](const Vector3& p) { return p.z() >= 0 && p.norm() <= r; };
  const auto inCylinder = [=](const Vector3& p) { return p.head<2>().norm() <= r && std::abs(p.z()) <= length / 2; };
  for (const Vector3& up : {Vector3(1, 2, 3), Vector3(-3, 1, -2), Vector3(1, 1, 0.1)}) {
    for (const double height : {-0.3, 0.15}) {
      SCOPED_TRACE(testing::Message() << up.transpose() << " at " << height);
      const Vector3 unit = up.normalized();
      expectNear(halfBallBelow(r, unit, height), counted(Vector3::Constant(r), inHalfBall, unit, height), 2e-2, "half");
      expectNear(cylinderBelow(r, length, unit, height), counted({r, r, length / 2}, inCylinder, unit, height), 4e-2,
                 "cylinder");
    }
  }
}

// the part below and the part above make the whole, to rounding
TEST(VolumeBelow, AndVolumeAboveMakeTheWhole) {
  for (const Vector3& up : directions()) {
    for (const double height : {-0.4, -0.05, 0.0, 0.15, 0.5}) {
      SCOPED_TRACE(testing::Message() << up.transpose() << " at " << height);
      VolumeMoments cylinder = cylinderBelow(0.7, 1.1, up, height);
      cylinder += cylinderBelow(0.7, 1.1, -up, -height);
      expectNear(cylinder, {kPi * 0.49 * 1.1, Vector3::Zero()}, 1e-8, "cylinder");
      VolumeMoments halfBall = halfBallBelow(0.7, up, height);
      halfBall += halfBallBelow(0.7, -up, -height);
      expectNear(halfBall, {kPi * 2 / 3 * 0.343, kPi / 4 * 0.2401 * Vector3::UnitZ()}, 1e-8, "half ball");
    }
  }
}

// a plane that cuts the side alone leaves a cylinder with a slanting end, of the same volume as a level one
TEST(VolumeBelow, IsThatOfACylinderWithASlantingEnd) {
  for (const double side : {1.0, -1.0}) {
    const Vector3 up = Vector3(0.3, -0.4, side).normalized();
    const VolumeMoments part = cylinderBelow(0.5, 3, up, 0.4 * std::abs(up.z()));
    EXPECT_NEAR(part.volume, kPi * 0.25 * 1.9, 1e-12);
    // the middle of the end lies in its plane; its slope shifts the centroid by r^2/(4 t) of it
    const Vector3 expected(-0.3 * 0.25 / 4 / 1.9, 0.4 * 0.25 / 4 / 1.9,
                           side * (-1.5 + (1.9 + 0.0625 * 0.25 / 1.9) / 2));
    EXPECT_NEAR((part.first / part.volume - expected).norm(), 0, 1e-12);
  }
  EXPECT_NEAR(cylinderBelow(0.5, 3, Vector3::UnitZ(), 5).volume, kPi * 0.75, 1e-12);
}

// where a plane cuts the sides alone, the long way and the short one lead to the same
TEST(VolumeBelow, IsThatOfAPrismWhereThatHasIt) {
  int both = 0;
  for (const Vector3& up : directions()) {
    for (const double height : {-0.4, -0.05, 0.0, 0.15, 0.5}) {
      SCOPED_TRACE(testing::Message() << up.transpose() << " at " << height);
      if (const auto box = Prism(BoxShape{{0.9, 1.2, 1.5}}).below(up, height)) {
        expectNear(boxBelow({0.9, 1.2, 1.5}, up, height), *box, 1e-13, "box");
        ++both;
      }
      if (const auto cylinder = Prism(CylinderShape{0.2, 1.5}).below(up, height)) {
        expectNear(cylinderBelow(0.2, 1.5, up, height), *cylinder, 1e-12, "cylinder");
        ++both;
      }
    }
  }
  EXPECT_GT(both, 20);
}

// W. Beyer, CRC Standard Mathematical Tables: an ungula through the diameter of the base holds 2/3 r^2 h
TEST(VolumeBelow, IsThatOfTheHoofOfACylinder) {
  const Vector3 up = Vector3(-1, 0, 1).normalized();
  // the plane z = x - 2 goes through the diameter of the base and rises by r = 1 at its rim
  EXPECT_NEAR(cylinderBelow(1, 4, up, -2 / std::sqrt(2)).volume, 2.0 / 3, 1e-12);
  // and its centroid lies 3 pi/16 r out and 3 pi/32 h up
  const VolumeMoments hoof = cylinderBelow(1, 4, up, -2 / std::sqrt(2));
  EXPECT_NEAR((hoof.first / hoof.volume - Vector3(3 * kPi / 16, 0, -2 + 3 * kPi / 32)).norm(), 0, 1e-12);
}

TEST(VolumeBelow, OfATetrahedronIsASmallerOne) {
  const std::vector<Vector3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const Vector3 up = Vector3::Constant(1 / std::sqrt(3));
  const VolumeMoments corner = trianglesBelow(vertices, triangles, up, 0.5 / std::sqrt(3));
  expectNear(corner, {1.0 / 48, Vector3::Constant(0.125 / 48)}, 1e-15, "corner");
  const VolumeMoments rest = trianglesBelow(vertices, triangles, -up, -0.5 / std::sqrt(3));
  EXPECT_NEAR(rest.volume, 1.0 / 6 - 1.0 / 48, 1e-15);
}

}  // namespace
}  // namespace pongsim::base
