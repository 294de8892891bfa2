#include "pongsim/geometry/solid.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/geometry/rotation_between.hh"

namespace pongsim {
namespace {

constexpr double kPi = std::numbers::pi;
const Vector3 kUp = Vector3(1, -2, 2) / 3;

/// A box of 1 x 2 x 3 m whose lower corner lies in (1, 0, 0), as a mesh.
struct MeshBox {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

  MeshBox() {
    for (unsigned i = 0; i < 8; ++i) {
      vertices.emplace_back((i & 1U) != 0 ? 2 : 1, (i & 2U) != 0 ? 2 : 0, (i & 4U) != 0 ? 3 : 0);
    }
  }
  Solid solid(const Vector3& scale = {1, 1, 1}) const {
    const auto kept = std::make_shared<MeshBox>(*this);
    return Solid(TriangleShape{kept->vertices, kept->triangles, scale, kept});
  }
};

TEST(Solid, KnowsTheVolumesOfPrimitives) {
  for (const auto& [solid, volume] : std::vector<std::pair<Solid, double>>{
           {Solid(BoxShape{{1, 2, 3}}), 6},
           {Solid(SphereShape{2}), kPi * 32 / 3},
           {Solid(CylinderShape{0.5, 3}), kPi * 0.75},
           {Solid(CapsuleShape{0.5, 3}), kPi * 0.75 + kPi / 6},
           {Solid(EllipsoidShape{{1, 2, 3}}), kPi * 8},
       }) {
    EXPECT_NEAR(solid.volume().size, volume, 1e-12 * volume);
    EXPECT_EQ(solid.volume().center, Vector3::Zero());
    EXPECT_TRUE(solid.isClosed());
  }
}

TEST(Solid, OfWhatHasNoInsideIsNothing) {
  for (const Shape& shape : {Shape(NoShape()), Shape(PlaneShape())}) {
    const Solid solid(shape);
    EXPECT_EQ(solid.volume().size, 0);
    EXPECT_TRUE(solid.bounds().isEmpty());
    EXPECT_FALSE(solid.isClosed());
    EXPECT_EQ(solid.below(Vector3::UnitZ(), 10).size, 0);
  }
}

TEST(Solid, LiesWithinItsBounds) {
  EXPECT_EQ(Solid(CapsuleShape{0.5, 3}).bounds().max(), Vector3(0.5, 0.5, 2));
  EXPECT_EQ(Solid(CylinderShape{0.5, 3}).bounds().min(), Vector3(-0.5, -0.5, -1.5));
  EXPECT_EQ(Solid(EllipsoidShape{{1, 2, 3}}).bounds().max(), Vector3(1, 2, 3));
  EXPECT_EQ(MeshBox().solid({-2, 1, 1}).bounds().min(), Vector3(-4, 0, 0));
  EXPECT_NEAR(Solid(BoxShape{{2, 3, 6}}).radius(), 3.5, 1e-15);
}

TEST(Solid, OfAMeshIsWhatItEncloses) {
  const Solid solid = MeshBox().solid();
  EXPECT_NEAR(solid.volume().size, 6, 1e-12);
  EXPECT_NEAR((solid.volume().center - Vector3(1.5, 1, 1.5)).norm(), 0, 1e-12);
  EXPECT_TRUE(solid.isClosed());
}

TEST(Solid, OfAMeshIsScaledAndMirrored) {
  const Solid solid = MeshBox().solid({-2, 0.5, 1});
  EXPECT_NEAR(solid.volume().size, 6, 1e-12);
  EXPECT_NEAR((solid.volume().center - Vector3(-3, 0.5, 1.5)).norm(), 0, 1e-12);
  // of 2 x 1 x 3 m, what is left of x = -3.5
  const Volume part = solid.below(Vector3::UnitX(), -3.5);
  EXPECT_NEAR(part.size, 1.5, 1e-12);
  EXPECT_NEAR((part.center - Vector3(-3.75, 0.5, 1.5)).norm(), 0, 1e-12);
}

TEST(Solid, OfAMeshThatIsInsideOutIsTheSame) {
  MeshBox box;
  for (auto& triangle : box.triangles) std::swap(triangle[0], triangle[1]);
  const Solid solid = box.solid();
  EXPECT_NEAR(solid.volume().size, 6, 1e-12);
  EXPECT_NEAR(solid.below(Vector3::UnitZ(), 1).size, 2, 1e-12);
  EXPECT_NEAR((solid.below(Vector3::UnitZ(), 1).center - Vector3(1.5, 1, 0.5)).norm(), 0, 1e-12);
}

TEST(Solid, SeesWhereASurfaceIsNotClosed) {
  MeshBox hole;
  hole.triangles.pop_back();
  EXPECT_FALSE(hole.solid().isClosed());
  MeshBox turned;
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_FALSE(turned.solid().isClosed());
}

TEST(Solid, TakesCornersOfOnePlaceForOne) {
  MeshBox shared;
  MeshBox soup;
  soup.vertices.clear();
  for (auto& triangle : soup.triangles) {
    for (auto& vertex : triangle) {
      soup.vertices.push_back(shared.vertices[vertex]);
      vertex = static_cast<std::uint32_t>(soup.vertices.size() - 1);
    }
  }
  EXPECT_TRUE(soup.solid().isClosed());
}

TEST(Solid, OfABoxBelowATiltedPlaneIsThatOfItsMesh) {
  const Solid box(BoxShape{{1, 2, 3}});
  const Solid mesh = MeshBox().solid();
  const Vector3 middle(1.5, 1, 1.5);
  // across its corners, and across the four edges along each axis
  for (const Vector3& direction : {Vector3(1, -2, 2), Vector3(0.05, -0.1, 1), Vector3(0.1, 1, -0.1),
                                   Vector3(-1, 0.03, 0.02), Vector3(0.1, 0.1, -1)}) {
    const Vector3 up = direction.normalized();
    for (const double height : {-1.0, -0.3, 0.0, 0.3, 0.8}) {
      const Volume expected = mesh.below(up, height + up.dot(middle));
      EXPECT_NEAR(box.below(up, height).size, expected.size, 1e-12);
      if (!(expected.size > 0)) continue;
      EXPECT_NEAR((box.below(up, height).center + middle - expected.center).norm(), 0, 1e-12);
    }
  }
}

TEST(Solid, OfAnEllipsoidBelowAPlaneThroughItsMiddleIsHalf) {
  const Volume half = Solid(EllipsoidShape{{1, 2, 3}}).below(kUp, 0);
  EXPECT_NEAR(half.size, kPi * 4, 1e-12);
  // 3/8 of the way from the middle to where a parallel plane touches: -(a^2 n_i) / |(a n)_i|
  const Vector3 touch = Vector3(1, 4, 9).cwiseProduct(kUp) / Vector3(1, 2, 3).cwiseProduct(kUp).norm();
  EXPECT_NEAR((half.center + 3.0 / 8 * touch).norm(), 0, 1e-12);
}

// Whatever the shape and the tilt, the parts below and above make the whole, and its middle lies between theirs.
TEST(Solid, IsCutIntoTwoThatMakeTheWhole) {
  for (const Shape& shape : {Shape(BoxShape{{1, 2, 3}}), Shape(SphereShape{0.8}), Shape(CylinderShape{0.5, 1.2}),
                             Shape(CapsuleShape{0.4, 0.9}), Shape(EllipsoidShape{{0.3, 0.5, 0.9}})}) {
    const Solid solid(shape);
    for (const Vector3& up : {kUp, Vector3(0, 0, 1), Vector3(1, 0, 0), Vector3(Vector3(-2, 1, -2) / 3)}) {
      for (const double height : {-0.6, -0.25, 0.0, 0.1, 0.35, 0.9}) {
        const Volume below = solid.below(up, height), above = solid.below(-up, -height);
        EXPECT_NEAR(below.size + above.size, solid.volume().size, 1e-9);
        EXPECT_NEAR((below.size * below.center + above.size * above.center).norm(), 0, 1e-9);
        if (below.size > 0) {
          EXPECT_LE(up.dot(below.center), height);
        }
      }
    }
  }
}

TEST(Solid, HasMomentsThatAreVolumeTimesCentroid) {
  for (const Solid& solid : {Solid(BoxShape{{1, 2, 3}}), Solid(SphereShape{0.8}), Solid(CylinderShape{0.5, 1.2}),
                             Solid(CapsuleShape{0.4, 0.9}), Solid(EllipsoidShape{{0.3, 0.5, 0.9}}), MeshBox().solid(),
                             Solid(PlaneShape())}) {
    EXPECT_EQ(solid.moments().volume, solid.volume().size);
    EXPECT_NEAR((solid.moments().first - solid.volume().size * solid.volume().center).norm(), 0, 1e-14);
    for (const double height : {-9.0, -0.25, 0.1, 9.0}) {
      const VolumeMoments moments = solid.momentsBelow(kUp, height);
      const Volume below = solid.below(kUp, height);
      EXPECT_EQ(moments.volume, below.size);
      EXPECT_NEAR((moments.first - below.size * below.center).norm(), 0, 1e-14);
      const Quaternion R = rotationBetween(kUp, Vector3::UnitZ());
      const VolumeMoments turned = solid.momentsBelowLevel(R, height);
      EXPECT_NEAR(turned.volume, moments.volume, 1e-13);
      EXPECT_NEAR((turned.first - R * moments.first).norm(), 0, 1e-13);
    }
  }
}

// the way to the formula for sides and ends and that to others meet where the plane comes to a rim
TEST(Solid, HasNoStepWhereAPlaneComesToAnEnd) {
  for (const Shape& shape : {Shape(BoxShape{{1, 1, 2}}), Shape(CylinderShape{0.5, 2}), Shape(CapsuleShape{0.5, 2})}) {
    const Solid solid(shape);
    const Vector3 up = Vector3(0.4, 0, 1).normalized();
    // 1 m up, less 0.4 of the half width
    const double rim = 0.8 * up.z();
    const VolumeMoments before = solid.momentsBelow(up, rim - 1e-9), after = solid.momentsBelow(up, rim + 1e-9);
    EXPECT_NEAR(after.volume, before.volume, 1e-8);
    EXPECT_NEAR((after.first - before.first).norm(), 0, 1e-8);
  }
}

TEST(Solid, OfACapsuleBelowAPlaneThroughItsEndIsACapOfTheBall) {
  const Volume cap = Solid(CapsuleShape{0.5, 2}).below(Vector3::UnitZ(), -1.2);
  EXPECT_NEAR(cap.size, kPi * 0.09 * (1.5 - 0.3) / 3, 1e-12);
  EXPECT_LT(cap.center.z(), -1.2);
}

}  // namespace
}  // namespace pongsim
