#include "sdf/readers/models/mass_properties.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "description/cone_triangles.hh"
#include "sdf/readers/shapes/extrusion.hh"

namespace pongsim::sdf {
namespace {

using description::Inertial;
using std::numbers::pi;

Inertial of(const description::Geometry& geometry, double density = 1000) {
  const MassProperties properties = massPropertiesOf(geometry, density).value();
  return properties.inertial(properties.mass);
}

void expectInertial(const Inertial& found, double mass, const Vector3& moments, double center = 0,
                    double tolerance = 1e-12) {
  EXPECT_NEAR(found.mass / mass, 1, tolerance);
  EXPECT_LT((found.X_LinkCom.position - Vector3(0, 0, center)).norm(), 1e-12 + tolerance);
  EXPECT_LT((found.moments - Matrix3(moments.asDiagonal())).norm() / moments.norm(), 1e-12 + tolerance)
      << found.moments;
}

TEST(MassProperties, OfSolidsAreThoseOfTheFormulas) {
  expectInertial(of(description::Box{{1, 2, 3}}), 6000, 500 * Vector3(13, 10, 5));
  expectInertial(of(description::Sphere{0.5}, 2000), 2000 * pi / 6, 2000 * pi / 6 * Vector3::Constant(0.1));
  expectInertial(of(description::Ellipsoid{{1, 2, 3}}), 8000 * pi, 1600 * pi * Vector3(13, 10, 5));
  const double cylinder = 500 * pi;
  expectInertial(of(description::Cylinder{0.5, 2}), cylinder,
                 cylinder * Vector3(1.0 / 16 + 1.0 / 3, 1.0 / 16 + 1.0 / 3, 1.0 / 8));
  const double cone = 500 * pi / 3;
  expectInertial(of(description::Cone{0.5, 2}), cone, cone * Vector3(0.1875, 0.1875, 0.075), -0.5);
}

TEST(MassProperties, OfACapsuleAreThoseOfItsParts) {
  // https://www.gamedev.net/tutorials/programming/math-and-physics/capsule-inertia-tensor-r3856/
  const double r = 0.5, h = 2, tube = 1000 * pi * r * r * h, ball = 1000 * 4 / 3.0 * pi * r * r * r;
  const double along = tube * r * r / 2 + ball * 2 * r * r / 5;
  const double across = tube * (h * h / 12 + r * r / 4) + ball * (2 * r * r / 5 + h * h / 4 + 3 * h * r / 8);
  expectInertial(of(description::Capsule{r, h}), tube + ball, {across, across, along});
  // that of a ball without a tube
  expectInertial(of(description::Capsule{r, 1e-9}), ball, ball * Vector3::Constant(0.1), 0, 1e-7);
}

description::Mesh meshOf(description::TriangleMesh triangles) {
  description::Mesh mesh;
  mesh.triangles = std::make_shared<const description::TriangleMesh>(std::move(triangles));
  return mesh;
}

TEST(MassProperties, OfAMeshAreThoseOfItsVolume) {
  // a box of 1 m x 2 m x 3 m, far away, from a mesh that is mirrored to it
  description::Mesh mesh = meshOf(*extrude({{{1000, 0}, {1002, 0}, {1002, 1}, {1000, 1}}}, 1));
  mesh.scale = {-0.5, 2, 3};
  const Inertial box = of(mesh);
  EXPECT_NEAR(box.mass, 6000, 1e-9);
  EXPECT_LT((box.X_LinkCom.position - Vector3(-500.5, 1, 1.5)).norm(), 1e-9);
  EXPECT_LT((box.moments - Matrix3((500 * Vector3(13, 10, 5)).asDiagonal())).norm(), 1e-4);
  // a cone of 48 sides
  const double cone = 500 * pi / 3;
  expectInertial(of(meshOf(description::coneTriangles({0.5, 2}))), cone, cone * Vector3(0.1875, 0.1875, 0.075), -0.5,
                 1e-3);
}

TEST(MassProperties, AddUpInAnyFrame) {
  // two halves of a box, each turned another way
  const double quarter = pi / 2;
  MassProperties sum =
      massPropertiesOf(description::Box{{2, 1, 3}}, 1000)->in({{1, 5, 0}, fromRollPitchYaw(0, 0, quarter)});
  sum += massPropertiesOf(description::Box{{1, 3, 2}}, 1000)->in({{2, 5, 0}, fromRollPitchYaw(quarter, 0, 0)});
  const Inertial box = sum.inertial(12'000);
  EXPECT_NEAR(sum.mass, 12'000, 1e-9);
  EXPECT_LT((box.X_LinkCom.position - Vector3(1.5, 5, 0)).norm(), 1e-12);
  EXPECT_LT((box.moments - Matrix3((1000 * Vector3(13, 13, 8)).asDiagonal())).norm(), 1e-8) << box.moments;
  EXPECT_LT((sum.inertial(12).moments - Matrix3(Vector3(13, 13, 8).asDiagonal())).norm(), 1e-8);
}

TEST(MassProperties, NeedAVolume) {
  for (const description::Geometry& geometry :
       {description::Geometry(description::Plane{}), description::Geometry(description::Empty{}),
        description::Geometry(description::Heightmap{}), description::Geometry(description::Image{}),
        description::Geometry(description::Mesh{}), description::Geometry(description::Polyline{})}) {
    EXPECT_FALSE(massPropertiesOf(geometry, 1000));
  }
}

}  // namespace
}  // namespace pongsim::sdf
