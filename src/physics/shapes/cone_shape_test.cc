#include "physics/shapes/cone_shape.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

TEST(ConeShape, HasItsOutermostPointsOnTipAndBase) {
  const ConeShape cone(0.3, 0.8);
  EXPECT_NEAR(cone.localGetSupportingVertex({0, 0, -1}).z(), -0.4, 1e-12);
  EXPECT_NEAR(cone.localGetSupportingVertex({0, 0, 2}).z(), 0.4, 1e-3);
  // perpendicular to its side
  const btVector3 normal = btVector3(0.8, 0, 0.3).normalized();
  const btScalar side = btVector3(0, 0, 0.4).dot(normal);
  EXPECT_NEAR(cone.localGetSupportingVertex(normal).dot(normal), side, 1e-12);
  EXPECT_NEAR(cone.localGetSupportingVertex({-1, 0, 0}).x(), -0.3, 1e-3);
  EXPECT_GE(cone.localGetSupportingVertex({-1, 0, 0}).x(), -0.3);
}

TEST(ConeShape, HasATightBox) {
  const ConeShape cone(0.3, 0.8);
  btVector3 lower, upper;
  cone.getAabb(btTransform(btQuaternion(btVector3(0, 1, 0), M_PI / 2), btVector3(10, 0, 0)), lower, upper);
  EXPECT_LT((lower - btVector3(9.6, -0.3, -0.3)).length(), 2e-3);
  EXPECT_LT((upper - btVector3(10.4, 0.3, 0.3)).length(), 2e-3);
  btVector3 inertia;
  cone.calculateLocalInertia(2, inertia);
  EXPECT_NEAR(inertia.x(), 2 * (0.15 * 0.09 + 0.1 * 0.64), 1e-12);
  EXPECT_NEAR(inertia.z(), 2 * 0.3 * 0.09, 1e-12);
}

/// @return A cone of 1 kg, radius 0.3 m and length 0.8 m.
description::Link coneLink(const Vector3& position, double roll) {
  description::Link link = test::makeLink("link", position, 1, {0.0255, 0.0255, 0.027});
  link.inertial.X_LinkCom.position = {0, 0, -0.2};
  link.X_ModelLink.rotation = fromRollPitchYaw(roll, 0, 0);
  test::addCollision(link, description::Cone{0.3, 0.8});
  return link;
}

test::Rig rigWith(const description::Link& link) {
  description::World world;
  world.models = {test::makeGround(), test::makeModel("body", {link})};
  return test::Rig(std::move(world));
}

TEST(ConeShape, StandsOnItsBase) {
  test::Rig rig = rigWith(coneLink({0, 0, 0.41}, 0.05));
  rig.step(3000);
  EXPECT_NEAR(rig.link("body::link").X_WorldLink.position.z(), 0.4, 1e-4);
  EXPECT_LT(rig.link("body::link").v_WorldLink.norm(), 1e-3);
}

TEST(ConeShape, LiesOnItsSide) {
  test::Rig rig = rigWith(coneLink({0, 0, 0.3}, 1.9));
  rig.step(10000);
  // the middle of its axis is half the radius, measured perpendicular to the side, above the ground
  EXPECT_NEAR(rig.link("body::link").X_WorldLink.position.z(), 0.15 * 0.8 / std::hypot(0.3, 0.8), 2e-3);
}

}  // namespace
}  // namespace pongsim::physics
