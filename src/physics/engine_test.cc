#include "physics/engine.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using description::JointType;
using test::addCollision;
using test::makeJoint;
using test::makeLink;
using test::makeModel;
using test::Rig;

description::Link makeBox(double z, double mass = 1) {
  const Vector3 size(0.4, 0.6, 0.2);
  description::Link link = makeLink("link", {0, 0, z}, mass, test::boxMoments(mass, size));
  addCollision(link, description::Box{size});
  return link;
}

// a heap: boxes that fall on each other
description::World fallingBoxes() {
  description::World world;
  world.models = {test::makeGround()};
  for (int i = 0; i < 6; ++i) {
    description::Model box = makeModel("box" + std::to_string(i), {makeBox(0.2)});
    box.X_ParentModel = {{0.05 * i, 0, 0.4 * i}, fromRollPitchYaw(0.3 * i, 0.1, 0.2 * i)};
    world.models.push_back(box);
  }
  return world;
}

TEST(Engine, KeepsABoxAtRestWhereItIs) {
  description::World world;
  world.models = {test::makeGround(), makeModel("box", {makeBox(0.1)})};
  Rig rig(std::move(world));
  rig.step(10000);
  const world::LinkState& box = rig.link("box::link");
  EXPECT_LT((box.X_WorldLink.position - Vector3(0, 0, 0.1)).norm(), 1e-5);
  EXPECT_NEAR(box.X_WorldLink.rotation.w(), 1, 1e-9);
  // the softness of its contacts lets it sink so fast as it is pushed out: g h 1e-4 and a little
  EXPECT_LT(box.v_WorldLink.norm(), 1e-5);
}

TEST(Engine, RollsAWheelAsFarAsItTurns) {
  description::Link wheel = makeLink("wheel", {0, 0, 0.3}, 2, {0.05, 0.05, 0.09});
  wheel.X_ModelLink.rotation = fromRollPitchYaw(-M_PI / 2, 0, 0);
  addCollision(wheel, description::Cylinder{0.3, 0.2});
  description::World world;
  world.models = {test::makeGround(), makeModel("model", {wheel})};
  Rig rig(std::move(world));
  // its turning axis, z of the link, lies along y of the world: positive is forward
  for (int i = 0; i < 500; ++i) {
    rig.engine.addLinkWrench(1, {0, 0, 0}, {0, 0.5, 0});
    rig.step(1);
  }
  rig.step(100);
  const double velocity = rig.link("model::wheel").v_WorldLink.x();
  // torque over (I + m r^2), times r
  EXPECT_NEAR(velocity, 0.5 * 0.5 / (0.09 + 2 * 0.09) * 0.3, 1e-4);
  const double start = rig.link("model::wheel").X_WorldLink.position.x();
  const double turning = rig.link("model::wheel").w_WorldLink.y();
  rig.step(4000);
  EXPECT_NEAR(rig.link("model::wheel").X_WorldLink.position.x() - start, 4 * turning * 0.3, 1e-3);
  EXPECT_NEAR(rig.link("model::wheel").X_WorldLink.position.y(), 0, 1e-3);
}

TEST(Engine, GivesTheSameBitsAgain) {
  Rig first(fallingBoxes());
  Rig second(fallingBoxes());
  for (int i = 0; i < 30; ++i) {
    first.step(100);
    second.step(100);
    ASSERT_EQ(world::stateHash(first.state), world::stateHash(second.state)) << "after " << (i + 1) * 100;
  }
}

TEST(Engine, SolvesARobotAsIfItWereAlone) {
  // two far apart, the second of them beside a third; the first must not notice
  description::World one;
  one.models = {test::makeGround(), makeModel("box", {makeBox(0.3)})};
  description::World three = one;
  for (double x : {10.0, 10.2}) {
    three.models.push_back(makeModel("box" + std::to_string(x), {makeBox(0.5)}));
    three.models.back().X_ParentModel.position.x() = x;
  }
  Rig alone(std::move(one));
  Rig amongOthers(std::move(three));
  alone.step(1000);
  amongOthers.step(1000);
  EXPECT_EQ(alone.link("box::link").X_WorldLink.position, amongOthers.link("box::link").X_WorldLink.position);
}

TEST(Engine, CarriesAHeavyBodyOnALightOne) {
  description::World world;
  world.models = {test::makeGround(), makeModel("light", {makeBox(0.1, 0.1)}), makeModel("heavy", {makeBox(0.3, 100)})};
  Rig rig(std::move(world));
  rig.step(3000);
  EXPECT_NEAR(rig.link("heavy::link").X_WorldLink.position.z(), 0.3, 2e-3);
  EXPECT_NEAR(rig.link("light::link").X_WorldLink.position.z(), 0.1, 2e-3);
}

TEST(Engine, NamesTheLinkWhoseMotionIsNotFiniteAnyMore) {
  description::World world;
  world.models = {makeModel("first", {makeBox(1)}), makeModel("second", {makeBox(5)})};
  Rig rig(std::move(world));
  rig.engine.addLinkWrench(1, {std::numeric_limits<double>::max(), 0, 0}, {0, 0, 0});
  try {
    rig.step(2);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("second::link"), std::string::npos) << error.what();
  }
}

TEST(Engine, LeavesStaticModelsAndTheirJointsAlone) {
  description::World world;
  description::Model gate = makeModel("gate", {makeBox(1), makeBox(2)});
  gate.links[1].name = "door";
  gate.isStatic = true;
  gate.joints.push_back(makeJoint("hinge", JointType::kRevolute, "link", "door", Pose(), Pose()));
  world.models = {gate};
  Rig rig(std::move(world));
  rig.engine.setJointVelocityTarget(0, 1);
  rig.step(10);
  EXPECT_EQ(rig.link("gate::door").X_WorldLink.position.z(), 2);
  EXPECT_EQ(rig.joint(0).position, 0);
}

TEST(Engine, PartsWhatBeginsInEachOtherWithoutThrowingIt) {
  description::World world;
  world.models = {test::makeGround(), makeModel("a", {makeBox(0.1)}), makeModel("b", {makeBox(0.12)}),
                  makeModel("c", {makeBox(0.05)})};
  Rig rig(std::move(world));
  double fastest = 0;
  for (int i = 0; i < 10000; ++i) {
    rig.step();
    for (const world::LinkState& link : rig.state.links) fastest = std::max(fastest, link.v_WorldLink.norm());
  }
  EXPECT_LT(fastest, 3);
  for (const char* name : {"a::link", "b::link", "c::link"}) {
    EXPECT_GT(rig.link(name).X_WorldLink.position.z(), 0.095) << name;
    EXPECT_LT(rig.link(name).v_WorldLink.norm(), 1e-2) << name;
  }
}

TEST(Engine, LetsWhatBeginsInTheGroundComeOutAtABoundedSpeed) {
  // 10 m/s^2 times the step
  for (const int milliseconds : {1, 2}) {
    description::World world;
    world.models = {test::makeGround(), makeModel("box", {makeBox(0.05)})};
    Rig rig(std::move(world));
    const auto run = [&](int duration) {
      for (int i = 0; i < duration / milliseconds; ++i) {
        rig.engine.step(std::chrono::milliseconds(milliseconds), rig.state);
        ASSERT_LT(rig.link("box::link").v_WorldLink.norm(), 1e-3);
      }
    };
    run(2000);
    EXPECT_NEAR(rig.link("box::link").X_WorldLink.position.z(), 0.05 + 0.01 * milliseconds * 2, 1e-3);
    run(4000);
    EXPECT_NEAR(rig.link("box::link").X_WorldLink.position.z(), 0.1, 1e-4);
  }
}

// no box turns more than once in a step, so the energy that so long a step gives is bounded too
TEST(Engine, StaysBoundedInStepsOfASecond) {
  description::World world = fallingBoxes();
  Rig rig(std::move(world));
  bool hasSlowedDown = false;
  for (int i = 0; i < 2000; ++i) {
    rig.engine.step(std::chrono::seconds(1), rig.state);
    hasSlowedDown = hasSlowedDown || rig.engine.slowedDown() != world::kNoSlot;
    for (const world::LinkState& link : rig.state.links) {
      ASSERT_LT(link.w_WorldLink.norm(), 6.2832) << "step " << i;
      ASSERT_LT(link.v_WorldLink.norm(), 100) << "step " << i;
    }
  }
  EXPECT_TRUE(hasSlowedDown);
}

TEST(Engine, LetsARotorTurnNearlyOnceAStep) {
  description::World world;
  world.gravity = Vector3::Zero();
  world.models = {makeModel("box", {makeBox(0.1)})};
  Rig rig(std::move(world));
  rig.engine.setLinkVelocity(0, Vector3::Zero(), {0, 0, 6000});
  rig.step(10);
  EXPECT_NEAR(rig.link("box::link").w_WorldLink.z(), 6000, 1e-6);
  EXPECT_EQ(rig.engine.slowedDown(), world::kNoSlot);
  rig.engine.setLinkVelocity(0, Vector3::Zero(), {0, 0, 7000});
  rig.step(1);
  EXPECT_NEAR(rig.link("box::link").w_WorldLink.z(), 6283.2, 0.1);
  EXPECT_EQ(rig.engine.slowedDown(), 0U);
}

TEST(Engine, LetsNoForceMakeALinkFasterThanItMayBe) {
  description::World world;
  world.gravity = Vector3::Zero();
  world.models = {makeModel("box", {makeBox(0.1)})};
  Rig rig(std::move(world));
  for (int i = 0; i < 100; ++i) {
    rig.engine.addLinkWrench(0, {1e10, 1e10, 0}, {0, 0, 1e10});
    rig.step(1);
    ASSERT_LE(rig.link("box::link").v_WorldLink.norm(), 1.0001e6) << "step " << i;
  }
  EXPECT_EQ(rig.engine.slowedDown(), 0U);
  // what is left is where it goes
  EXPECT_NEAR(rig.link("box::link").v_WorldLink.x(), 1e6 / std::sqrt(2), 1);
}

TEST(Engine, MakesStepsOfAnyLength) {
  description::World world;
  world.gravity = {0, 0, -10};
  world.models = {makeModel("box", {makeBox(1)})};
  Rig rig(std::move(world));
  rig.engine.step(std::chrono::milliseconds(50), rig.state);
  EXPECT_NEAR(rig.link("box::link").v_WorldLink.z(), -0.5, 1e-12);
}

}  // namespace
}  // namespace pongsim::physics
