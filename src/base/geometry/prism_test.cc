#include "pongsim/geometry/prism.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pongsim {
namespace {

/// Of a box that stands upright, by its four edges: each fourth of it under a flat piece of the slanting end.
VolumeMoments boxByStrips(const Vector3& size, const Vector3& up, double height) {
  constexpr int kStrips = 200;
  VolumeMoments sum;
  const double dx = size.x() / kStrips, dy = size.y() / kStrips;
  for (int i = 0; i < kStrips; ++i) {
    for (int j = 0; j < kStrips; ++j) {
      const double x = (i + 0.5) * dx - size.x() / 2, y = (j + 0.5) * dy - size.y() / 2;
      const double end = (height - up.x() * x - up.y() * y) / up.z();
      const double from = up.z() > 0 ? -size.z() / 2 : end, to = up.z() > 0 ? end : size.z() / 2;
      const double volume = dx * dy * (to - from);
      sum += {volume, volume * Vector3(x, y, (from + to) / 2)};
    }
  }
  return sum;
}

TEST(Prism, OfABoxIsWhatItsStripsAddUpTo) {
  const Vector3 size(1, 2, 3);
  for (const Vector3& direction : {Vector3(0.1, -0.2, 1), Vector3(0.3, 0.1, -1), Vector3(0, 0, 1), Vector3(0, 0, -1)}) {
    const Vector3 up = direction.normalized();
    for (const double height : {-0.7, 0.0, 0.4}) {
      const auto part = Prism(BoxShape{size}).below(up, height);
      ASSERT_TRUE(part);
      const VolumeMoments strips = boxByStrips(size, up, height);
      EXPECT_NEAR(part->volume, strips.volume, 1e-9);
      EXPECT_NEAR((part->first - strips.first).norm(), 0, 4e-5) << up.transpose() << " at " << height;
    }
  }
}

// the same box turned about its diagonal, so that x is what was z
TEST(Prism, OfABoxIsAlongEachOfItsAxes) {
  const Vector3 up = Vector3(0.2, -0.1, 0.9).normalized();
  const auto part = Prism(BoxShape{{1, 2, 3}}).below(up, 0.2);
  const auto turned = Prism(BoxShape{{3, 1, 2}}).below({up.z(), up.x(), up.y()}, 0.2);
  const auto twice = Prism(BoxShape{{2, 3, 1}}).below({up.y(), up.z(), up.x()}, 0.2);
  ASSERT_TRUE(part && turned && twice);
  EXPECT_NEAR(turned->volume, part->volume, 1e-15);
  EXPECT_NEAR(twice->volume, part->volume, 1e-15);
  EXPECT_NEAR((Vector3(turned->first.y(), turned->first.z(), turned->first.x()) - part->first).norm(), 0, 1e-15);
  EXPECT_NEAR((Vector3(twice->first.z(), twice->first.x(), twice->first.y()) - part->first).norm(), 0, 1e-15);
}

// its slope shifts the centroid by r^2/(4 t) of it, where t is the length in the middle
TEST(Prism, OfACylinderHasASlantingEnd) {
  for (const double side : {1.0, -1.0}) {
    const Vector3 up = Vector3(0.3, -0.4, side).normalized();
    const auto part = Prism(CylinderShape{0.5, 3}).below(up, 0.4 * std::abs(up.z()));
    ASSERT_TRUE(part);
    EXPECT_NEAR(part->volume, std::numbers::pi * 0.25 * 1.9, 1e-12);
    const Vector3 expected(-0.3 * 0.25 / 4 / 1.9, 0.4 * 0.25 / 4 / 1.9,
                           side * (-1.5 + (1.9 + 0.0625 * 0.25 / 1.9) / 2));
    EXPECT_NEAR((part->first / part->volume - expected).norm(), 0, 1e-12);
  }
}

TEST(Prism, OfACapsuleHasARoundEnd) {
  for (const double side : {1.0, -1.0}) {
    const auto part = Prism(CapsuleShape{0.3, 0.8}).below({0, 0, side}, 0.1);
    ASSERT_TRUE(part);
    const double ball = std::numbers::pi * 2 / 3 * 0.027, sides = std::numbers::pi * 0.09 * 0.5;
    EXPECT_NEAR(part->volume, ball + sides, 1e-15);
    const double first = sides * -0.15 - ball * (0.4 + 0.3 * 3 / 8);
    EXPECT_NEAR((part->first - Vector3(0, 0, side * first)).norm(), 0, 1e-15);
  }
}

// two halves of one that is tilted, whose middle is the origin
TEST(Prism, AboveAndBelowMakeTheWhole) {
  const Vector3 up = Vector3(-0.2, 0.1, 0.8).normalized();
  for (const auto& [prism, volume] :
       {std::pair(Prism(BoxShape{{1, 2, 3}}), 6.0), std::pair(Prism(CylinderShape{0.5, 2}), std::numbers::pi / 2),
        std::pair(Prism(CapsuleShape{0.5, 2}), std::numbers::pi / 2 + std::numbers::pi / 6)}) {
    auto both = prism.below(up, 0.3), above = prism.below(-up, -0.3);
    ASSERT_TRUE(both && above);
    *both += *above;
    EXPECT_NEAR(both->volume, volume, 1e-14);
    EXPECT_NEAR(both->first.norm(), 0, 1e-14);
  }
}

// turned into the world, what is below a level plane is the same
TEST(Prism, BelowALevelPlaneIsThatOfItsOwnFrame) {
  for (const Prism& prism :
       {Prism(BoxShape{{1, 2, 3}}), Prism(CylinderShape{0.5, 2}), Prism(CapsuleShape{0.5, 2}), Prism()}) {
    int found = 0;
    for (const Vector3& turn : {Vector3(0, 0, 0), Vector3(0.2, -0.3, 1), Vector3(3.1, 0.1, -2), Vector3(1.6, 0.1, 0.3),
                                Vector3(0.1, 1.5, 0.2), Vector3(-1.5, 0.1, 2)}) {
      const Quaternion R = fromRollPitchYaw(turn.x(), turn.y(), turn.z());
      for (const double height : {-0.3, 0.0, 0.2}) {
        const auto turned = prism.belowLevel(R, height);
        const auto part = prism.below(R.conjugate() * Vector3::UnitZ(), height);
        ASSERT_EQ(turned.has_value(), part.has_value()) << turn.transpose();
        if (!part) continue;
        ++found;
        EXPECT_NEAR(turned->volume, part->volume, 1e-14) << turn.transpose();
        EXPECT_NEAR((turned->first - R * part->first).norm(), 0, 1e-14) << turn.transpose();
      }
    }
    EXPECT_EQ(found > 6, prism.below(Vector3::UnitZ(), 0).has_value());
  }
}

TEST(Prism, LeavesAPlaneThatMeetsItsEndsToOthers) {
  const Vector3 level = Vector3::UnitZ(), tilted = Vector3(0.3, 0, 1).normalized();
  // at an edge of the box the plane is 0.15 m higher or lower than in the middle
  const Prism box(BoxShape{{1, 1, 1}});
  EXPECT_TRUE(box.below(tilted, 0.349 * tilted.z()));
  EXPECT_FALSE(box.below(tilted, 0.351 * tilted.z()));
  EXPECT_FALSE(box.below(tilted, -0.351 * tilted.z()));
  EXPECT_FALSE(box.below(level, 0.6));
  // at the rim of the cylinder likewise, also between the axes
  const Prism cylinder(CylinderShape{0.5, 1});
  EXPECT_TRUE(cylinder.below(tilted, 0.349 * tilted.z()));
  EXPECT_FALSE(cylinder.below(tilted, 0.351 * tilted.z()));
  const Vector3 diagonal = Vector3(0.3 * std::sqrt(0.5), 0.3 * std::sqrt(0.5), 1).normalized();
  EXPECT_TRUE(cylinder.below(diagonal, 0.349 * diagonal.z()));
  EXPECT_FALSE(cylinder.below(diagonal, 0.351 * diagonal.z()));
  // a plane along the axis meets both ends
  EXPECT_FALSE(cylinder.below(Vector3::UnitX(), 0));
  EXPECT_FALSE(Prism().below(level, 0));
}

}  // namespace
}  // namespace pongsim
