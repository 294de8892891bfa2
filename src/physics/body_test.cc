#include "physics/body.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using test::makeLink;
using test::makeModel;
using test::Rig;

Rig freeBody(const description::Link& link, const Vector3& gravity = Vector3::Zero()) {
  description::World world;
  world.gravity = gravity;
  world.models = {makeModel("body", {link})};
  return Rig(std::move(world));
}

// angular momentum of a link about its centre of mass, world frame
Vector3 angularMomentum(const description::Link& link, const world::LinkState& state) {
  const Matrix3 R = (state.X_WorldLink.rotation * link.inertial.X_LinkCom.rotation).toRotationMatrix();
  return R * link.inertial.moments * R.transpose() * state.w_WorldLink;
}

TEST(Body, FallsAsTheSemiImplicitEulerMethodHasIt) {
  Rig rig = freeBody(makeLink("link", {0, 0, 10}, 2, {1, 1, 1}), {0, 0, -9.8});
  rig.step(1000);
  // v_n = n g h and z_n = z_0 + g h^2 n (n + 1) / 2: g h t / 2 lower than the parabola
  EXPECT_NEAR(rig.link("body::link").v_WorldLink.z(), -9.8, 1e-10);
  EXPECT_NEAR(rig.link("body::link").X_WorldLink.position.z(), 10 - 9.8 * 1e-6 * 1000 * 1001 / 2, 1e-10);
}

TEST(Body, DoesNotFallWithoutGravityOfItsOwn) {
  description::Link link = makeLink("link", {0, 0, 10}, 2, {1, 1, 1});
  link.gravity = false;
  Rig rig = freeBody(link, {0, 0, -9.8});
  rig.step(100);
  EXPECT_EQ(rig.link("body::link").X_WorldLink.position.z(), 10);
}

TEST(Body, LosesSpeedByItsVelocityDecayOnly) {
  description::Link link = makeLink("link", {0, 0, 0}, 2, {1, 1, 1});
  link.linearDamping = 0.3;
  Rig rig = freeBody(link);
  rig.engine.addLinkWrench(0, {2000, 0, 0}, {0, 0, 0});
  rig.step(1);
  const double start = rig.link("body::link").v_WorldLink.x();
  rig.step(1000);
  EXPECT_NEAR(rig.link("body::link").v_WorldLink.x() / start, 0.7, 1e-3);
}

TEST(Body, TellsTheVelocityOfTheLinkOriginNotOfTheCentreOfMass) {
  description::Link link = makeLink("link", {1, 2, 3}, 2, {1, 1, 1});
  link.inertial.X_LinkCom.position = {0.5, 0, 0};
  Rig rig = freeBody(link);
  rig.engine.addLinkWrench(0, {0, 0, 0}, {0, 0, 1000});
  rig.step(1);
  // a pure torque turns it about the centre of mass: the origin half a metre to its left moves down y
  EXPECT_NEAR(rig.link("body::link").w_WorldLink.z(), 1, 1e-9);
  EXPECT_NEAR(rig.link("body::link").v_WorldLink.y(), -0.5, 1e-3);
  rig.step(999);
  const Vector3 com(1.5, 2, 3);
  const Vector3 expected = com - 0.5 * Vector3(std::cos(1.0), std::sin(1.0), 0);
  EXPECT_TRUE(rig.link("body::link").X_WorldLink.position.isApprox(expected, 1e-6));
}

TEST(Body, TakesAForceAtTheLinkOrigin) {
  description::Link link = makeLink("link", {0, 0, 0}, 2, {1, 1, 4});
  link.inertial.X_LinkCom.position = {0.5, 0, 0};
  Rig rig = freeBody(link);
  rig.engine.addLinkWrench(0, {0, 1000, 0}, {0, 0, 0});
  rig.step(1);
  // torque about the centre of mass (-0.5, 0, 0) x (0, 1000, 0) = -500 z
  EXPECT_NEAR(rig.link("body::link").w_WorldLink.z(), -500 * 0.001 / 4, 1e-6);
}

TEST(Body, KeepsItsAngularMomentumInFreeRotation) {
  description::Link link = makeLink("link", {0, 0, 0}, 1, {0.1, 0.2, 0.3});
  link.inertial.X_LinkCom = {{0.1, -0.2, 0.05}, fromRollPitchYaw(0.3, 0.5, -0.8)};
  link.inertial.moments(0, 1) = link.inertial.moments(1, 0) = 0.03;
  Rig rig = freeBody(link);
  rig.engine.addLinkWrench(0, {0, 0, 0}, {100, 300, -200});
  rig.step(1);
  const Vector3 start = angularMomentum(link, rig.link("body::link"));
  ASSERT_GT(start.norm(), 0.3);
  rig.step(5000);
  // the gyroscopic term is implicit, of first order: it may damp, and no more than that
  const Vector3 end = angularMomentum(link, rig.link("body::link"));
  EXPECT_LT((end - start).norm() / start.norm(), 0.02);
}

TEST(Body, StandsStillWhereItIsKinematicOrStatic) {
  description::Link link = makeLink("link", {0, 0, 10}, 2, {1, 1, 1});
  link.kinematic = true;
  Rig rig = freeBody(link, {0, 0, -9.8});
  rig.engine.addLinkWrench(0, {1000, 0, 0}, {0, 0, 0});
  rig.step(10);
  EXPECT_EQ(rig.link("body::link").X_WorldLink.position, Vector3(0, 0, 10));
}

TEST(Body, NamesALinkWithoutMass) {
  try {
    freeBody(makeLink("link", {0, 0, 0}, 0, {1, 1, 1}));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("body::link"), std::string::npos);
  }
}

}  // namespace
}  // namespace pongsim::physics
