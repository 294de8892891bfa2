#include "physics/shapes/ellipsoid_shape.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

TEST(EllipsoidShape, HasItsOutermostPointsOnItsSurface) {
  const btVector3 radii(1, 2, 3);
  const EllipsoidShape shape(radii);
  EXPECT_EQ(shape.localGetSupportingVertex({1, 0, 0}), btVector3(1, 0, 0));
  EXPECT_EQ(shape.localGetSupportingVertex({0, 0, -5}), btVector3(0, 0, -3));
  for (int i = 0; i < 100; ++i) {
    const btVector3 direction(std::sin(3.0 * i), std::cos(5.0 * i), std::sin(7.0 * i + 1));
    const btVector3 point = shape.localGetSupportingVertex(direction);
    EXPECT_NEAR((point / radii).length(), 1, 1e-12);
    // the surface's normal there is the direction
    EXPECT_NEAR((point / radii / radii).normalized().dot(direction.normalized()), 1, 1e-12);
  }
}

TEST(EllipsoidShape, HasATightBox) {
  const EllipsoidShape shape(btVector3(1, 2, 3));
  btVector3 lower, upper;
  shape.getAabb(btTransform(btQuaternion(btVector3(0, 0, 1), M_PI / 2), btVector3(10, 0, 0)), lower, upper);
  EXPECT_LT((lower - btVector3(8, -1, -3)).length(), 1e-12);
  EXPECT_LT((upper - btVector3(12, 1, 3)).length(), 1e-12);
  btVector3 inertia;
  shape.calculateLocalInertia(5, inertia);
  EXPECT_EQ(inertia, btVector3(13, 10, 5));
}

TEST(EllipsoidShape, RollsOntoItsFlatSide) {
  // let go on its edge, a little tilted
  description::Link link = test::makeLink("link", {0, 0, 1.05}, 1, {0.2, 0.2, 0.4});
  link.X_ModelLink.rotation = fromRollPitchYaw(1.4, 0, 0);
  link.angularDamping = 0.5;
  test::addCollision(link, description::Ellipsoid{{1, 1, 0.5}});
  description::World world;
  world.models = {test::makeGround(), test::makeModel("body", {link})};
  test::Rig rig(std::move(world));
  rig.step(20000);
  EXPECT_NEAR(rig.link("body::link").X_WorldLink.position.z(), 0.5, 0.02);
}

}  // namespace
}  // namespace pongsim::physics
