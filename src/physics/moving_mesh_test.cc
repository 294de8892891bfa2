// Moving meshes that are not convex, compared with mechanics.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "sdf/readers/shapes/extrusion.hh"
#include "support/physics/rig.hh"
#include "support/solids.hh"

namespace pongsim::physics {
namespace {

using test::addCollision;
using test::makeLink;
using test::makeModel;
using test::Rig;

description::Mesh shapeOf(description::TriangleMesh triangles) {
  description::Mesh mesh;
  mesh.triangles = std::make_shared<const description::TriangleMesh>(std::move(triangles));
  return mesh;
}

description::Model modelOf(std::string name, const description::Geometry& shape, const Vector3& position,
                           double mass = 1, double inertia = 0.01, double mu = 1) {
  description::Link link = makeLink("link", position, mass, Vector3::Constant(inertia));
  addCollision(link, shape, mu);
  return makeModel(std::move(name), {link});
}

/// A level floor of triangles, 10 m by 10 m.
description::Model floorOfTriangles() {
  description::TriangleMesh mesh;
  mesh.vertices = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  description::Model model = modelOf("ground", shapeOf(mesh), {0, 0, 0});
  model.isStatic = true;
  return model;
}

/// A bowl of 0.2 m whose rim looks up, resting on its bottom.
description::Model makeBowl() {
  description::Model model = modelOf("bowl", shapeOf(test::bowl(0.2, 0.02, 32, 10)), {0, 0, 0.2}, 2, 0.04);
  model.links[0].inertial.X_LinkCom.position = {0, 0, -0.15};
  return model;
}

TEST(MovingMesh, ABowlHoldsABall) {
  for (const bool isOnTriangles : {false, true}) {
    description::World world;
    world.models = {isOnTriangles ? floorOfTriangles() : test::makeGround(), makeBowl(),
                    modelOf("ball", description::Sphere{0.05}, {0.05, 0, 0.3}, 0.2, 0.0002)};
    Rig rig(std::move(world));
    double lowest = 1;
    for (int i = 0; i < 10000; ++i) {
      rig.step();
      lowest = std::min(lowest, rig.link("ball::link").X_WorldLink.position.z());
    }
    const Vector3 ball = rig.link("ball::link").X_WorldLink.position;
    const Vector3 bowl = rig.link("bowl::link").X_WorldLink.position;
    // on the inner side: at the bottom of it the ball's middle would be at 0.07
    EXPECT_NEAR((ball - bowl).norm(), 0.18 - 0.05, 0.008);
    EXPECT_LT((ball - bowl).head<2>().norm(), 0.04);
    EXPECT_GT(lowest, 0.062);
    EXPECT_NEAR(bowl.z(), 0.2, 0.002);
  }
}

TEST(MovingMesh, AnAngleIronStandsOnItsLegsAndBearsOnTheLowerOne) {
  // upright: the long leg below; its top is at 0.1
  description::World world;
  world.models = {test::makeGround(), modelOf("iron", shapeOf(test::angleIron(0.1, 0.1)), {0, 0, 0.001}, 4, 0.02)};
  world.models[1].links[0].inertial.X_LinkCom.position = {0.125, 0, 0.075};
  world.models.push_back(modelOf("ball", description::Sphere{0.04}, {0.2, 0, 0.15}, 0.1, 1e-4));
  world.models.push_back(modelOf("box", description::Box{{0.06, 0.06, 0.06}}, {0.05, 0, 0.24}, 0.1, 6e-5));
  Rig rig(std::move(world));
  rig.step(2000);
  EXPECT_NEAR(rig.link("iron::link").X_WorldLink.position.z(), 0, 1e-4);
  EXPECT_NEAR(rig.link("ball::link").X_WorldLink.position.z(), 0.1 + 0.04, 2e-4);
  EXPECT_NEAR(rig.link("box::link").X_WorldLink.position.z(), 0.2 + 0.03, 2e-4);
}

TEST(MovingMesh, AnAngleIronRestsOnTheTipsOfItsLegs) {
  // corner up: it rests on the inner edges of both ends, the line from (3, 1) to (1, 2) being level, and has room for a
  // box below
  const double unit = 0.1;
  const double slope = std::atan2(1.0, 2.0);
  description::Model iron = modelOf("iron", shapeOf(test::angleIron(unit, 0.2)), {0, 0, 0.3}, 4, 0.03);
  iron.links[0].inertial.X_LinkCom.position = {0.125, 0, 0.075};
  // pitch turns x down: by pi - slope the corner looks up
  iron.links[0].X_ModelLink.rotation = fromRollPitchYaw(0, std::numbers::pi - slope, 0);
  // the corner's distance from the line through both, x + 2 z = 5
  const double height = unit * std::sqrt(5.0);
  iron.links[0].X_ModelLink.position.z() = height + 0.002;
  description::World world;
  // the inner corner is at 5 / sqrt(5) - 3 / sqrt(5) units, above x = 1 / sqrt(5) units
  const double below = -unit / std::sqrt(5.0);
  world.models = {test::makeGround(), iron, modelOf("box", description::Box{{0.02, 0.02, 0.06}}, {below, 0, 0.03})};
  world.models[2].isStatic = true;
  Rig rig(std::move(world));
  rig.step(3000);
  const auto& link = rig.link("iron::link");
  EXPECT_NEAR(link.X_WorldLink.position.z(), height, 3e-4);
  EXPECT_LT(link.v_WorldLink.norm(), 1e-3);
  const Vector3 corner = link.X_WorldLink * Vector3(unit, 0, unit);
  EXPECT_NEAR(corner.x(), below, 2e-3);
  EXPECT_NEAR(corner.z(), unit * 2 / std::sqrt(5.0), 3e-4);
}

TEST(MovingMesh, AConcaveMeshOnAConcaveMesh) {
  // two U profiles, the upper one turned round, so that each has a leg in the other's gap
  const double a = 0.1;
  const sdf::Outline outline{
      {{0, 0}, {3 * a, 0}, {3 * a, 2 * a}, {2 * a, 2 * a}, {2 * a, a}, {a, a}, {a, 2 * a}, {0, 2 * a}}};
  const description::TriangleMesh u =
      test::moved(*sdf::extrude(outline, 0.2), {{0, 0.1, 0}, fromRollPitchYaw(std::numbers::pi / 2, 0, 0)});
  description::Model lower = modelOf("lower", shapeOf(u), {0, 0, 0.001}, 5, 0.05);
  lower.links[0].inertial.X_LinkCom.position = {0.15, 0, 0.08};
  // upside down, its left leg 5 mm off the walls of the gap
  const double slim = 0.095;
  const sdf::Outline hook{
      {{0, 0}, {3 * a, 0}, {3 * a, 2 * a}, {2 * a, 2 * a}, {2 * a, a}, {slim, a}, {slim, 2 * a}, {0, 2 * a}}};
  const description::TriangleMesh h =
      test::moved(*sdf::extrude(hook, 0.2), {{0, 0.1, 0}, fromRollPitchYaw(std::numbers::pi / 2, 0, 0)});
  description::Model upper =
      modelOf("upper", shapeOf(test::moved(h, {{0, 0, 0}, fromRollPitchYaw(0, std::numbers::pi, 0)})),
              {0.1 + slim + 0.0025, 0, 0.302}, 1, 0.01);
  upper.links[0].inertial.X_LinkCom.position = {-0.05, 0, -0.1};
  description::World world;
  world.models = {test::makeGround(), lower, upper};
  Rig rig(std::move(world));
  rig.step(2000);
  // the hook's leg stands on the bottom of the gap at a, and its own gap lies on the leg at 2 a: its back is at 3 a
  EXPECT_NEAR(rig.link("upper::link").X_WorldLink.position.z(), 3 * a, 5e-4);
  EXPECT_NEAR(rig.link("lower::link").X_WorldLink.position.z(), 0, 2e-4);
  EXPECT_LT(rig.link("upper::link").v_WorldLink.norm(), 1e-3);
}

TEST(MovingMesh, ASpokedWheelRollsItsWay) {
  const double radius = 0.2;
  // at each corner it loses speed: with 60 sides 5 % of the way
  const std::uint32_t sides = 360;
  for (const bool isOnTriangles : {false, true}) {
    description::Model wheel =
        modelOf("wheel", shapeOf(test::spokedWheel(radius, 0.05, sides, 5)), {-4, 0, radius}, 1, 0.02);
    const double inertia = 0.03;
    wheel.links[0].inertial.moments = Vector3(0.02, inertia, 0.02).asDiagonal();
    description::World world;
    world.models = {isOnTriangles ? floorOfTriangles() : test::makeGround(), wheel};
    // down a slope of 5 %, which is a push along x
    world.gravity = {0.49, 0, -9.8};
    Rig rig(std::move(world));
    const double acceleration = 0.49 / (1 + inertia / (radius * radius));
    rig.step(3000);
    const auto& link = rig.link("wheel::link");
    const double way = link.X_WorldLink.position.x() + 4;
    EXPECT_NEAR(way, acceleration * 9 / 2, 0.02 * acceleration * 9 / 2) << isOnTriangles;
    // it rolls: on the corners of its sides, as far as their circumference says
    EXPECT_NEAR(link.w_WorldLink.y() * radius, link.v_WorldLink.x(), 0.02 * link.v_WorldLink.x());
    EXPECT_NEAR(link.X_WorldLink.position.y(), 0, 0.02);
  }
}

TEST(MovingMesh, FingersCloseRoundAPegAndLiftIt) {
  using description::JointType;
  // two hooks of a C each, 60 mm deep, that close on a peg of 40 mm
  const sdf::Outline outline{
      {{0, -0.05}, {0.06, -0.05}, {0.06, -0.03}, {0.02, -0.03}, {0.02, 0.03}, {0.06, 0.03}, {0.06, 0.05}, {0, 0.05}}};
  const description::TriangleMesh left = *sdf::extrude(outline, 0.06);
  description::Link palm = makeLink("palm", {0, 0, 0.3}, 2, Vector3::Constant(0.01));
  description::Link one = makeLink("one", {-0.1, 0, 0.05}, 0.2, Vector3::Constant(1e-3));
  description::Link other = makeLink("other", {0.1, 0, 0.05}, 0.2, Vector3::Constant(1e-3));
  addCollision(one, shapeOf(left));
  addCollision(other, shapeOf(test::moved(left, {{0, 0, 0}, fromRollPitchYaw(0, 0, std::numbers::pi)})));
  description::Model gripper = makeModel("gripper", {palm, one, other});
  gripper.joints.push_back(
      test::makeJoint("lift", JointType::kPrismatic, "world", "palm", test::at(0, 0, 0.3), Pose()));
  gripper.joints.push_back(
      test::makeJoint("a", JointType::kPrismatic, "palm", "one", test::at(-0.1, 0, -0.25), Pose(), Vector3::UnitX()));
  gripper.joints.push_back(
      test::makeJoint("b", JointType::kPrismatic, "palm", "other", test::at(0.1, 0, -0.25), Pose(), -Vector3::UnitX()));
  for (std::size_t i = 0; i < 3; ++i) gripper.joints[i].axes[0].effort = i == 0 ? 200 : 10;
  description::World world;
  // off the middle: the hooks' mouths take it
  world.models = {test::makeGround(), gripper,
                  modelOf("peg", description::Cylinder{0.02, 0.12}, {0.01, 0.005, 0.06}, 0.1, 1e-4)};
  Rig rig(std::move(world));
  for (const world::Slot slot : {0, 1, 2}) rig.engine.setJointVelocityTarget(slot, slot == 0 ? 0 : 0.05);
  rig.step(2500);
  const Vector3 held = rig.link("peg::link").X_WorldLink.position;
  // it is in both hooks, which have met round it: their backs are nearer than their mouths are deep
  EXPECT_LT(std::abs(held.x()), 0.03);
  const double gap =
      rig.link("gripper::other").X_WorldLink.position.x() - rig.link("gripper::one").X_WorldLink.position.x();
  EXPECT_LT(gap, 0.125);
  rig.engine.setJointVelocityTarget(0, 0.1);
  rig.step(1500);
  rig.engine.setJointVelocityTarget(0, 0);
  rig.step(500);
  EXPECT_NEAR(rig.link("gripper::palm").X_WorldLink.position.z(), 0.45, 0.01);
  EXPECT_NEAR(rig.link("peg::link").X_WorldLink.position.z() - held.z(), 0.15, 0.01);
}

TEST(MovingMesh, APolylineHasItsHole) {
  // a nut that is dropped over a peg
  description::Polyline ring;
  ring.lines = {{{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}},
                {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}};
  ring.height = 0.1;
  ring.triangles = sdf::extrude(ring.lines, ring.height);
  description::World world;
  world.models = {test::makeGround(), modelOf("peg", description::Cylinder{0.08, 0.4}, {0, 0, 0.2}),
                  modelOf("ring", ring, {0, 0, 0.5}, 1, 0.02)};
  world.models[1].isStatic = true;
  world.models[2].links[0].inertial.X_LinkCom.position = {0, 0, 0.05};
  Rig rig(std::move(world));
  rig.step(2000);
  EXPECT_NEAR(rig.link("ring::link").X_WorldLink.position.z(), 0, 1e-3);
}

TEST(MovingMesh, TellsOfContactsByItsCollision) {
  description::World world;
  world.models = {test::makeGround(), makeBowl(), modelOf("ball", description::Sphere{0.05}, {0, 0, 0.1}, 0.2, 0.0002)};
  Rig rig(std::move(world));
  rig.step(1000);
  std::vector<Contact> contacts;
  rig.engine.contacts(contacts);
  ASSERT_FALSE(contacts.empty());
  const auto idOf = [&](std::string_view link) {
    return rig.entities.collisions()[rig.entities.links()[rig.entities.findLink(link)].firstCollision].id;
  };
  const CollisionId bowl = idOf("bowl::link"), ball = idOf("ball::link");
  double weight = 0;
  for (const Contact& contact : contacts) {
    const bool isBall = contact.collision1 == ball || contact.collision2 == ball;
    EXPECT_TRUE(contact.collision1 == bowl || contact.collision2 == bowl);
    if (isBall) weight += std::abs(contact.force.z());
  }
  EXPECT_NEAR(weight, 0.2 * 9.8, 0.01);
}

TEST(MovingMesh, TouchesAtNoMorePointsThanMayBe) {
  for (const long long most : {0, 1, 6, 20}) {
    description::World world;
    world.models = {test::makeGround(),
                    modelOf("comb", shapeOf([] {
                              description::TriangleMesh comb = test::boxBetween({0, 0, 0.1}, {1, 0.1, 0.2});
                              for (int i = 0; i < 10; ++i) {
                                test::append(test::boxBetween({0.1 * i, 0, 0}, {0.1 * i + 0.05, 0.1, 0.15}), comb);
                              }
                              return comb;
                            }()),
                            {0, 0, 0.0005}, 1, 0.05)};
    world.models[1].links[0].inertial.X_LinkCom.position = {0.475, 0.05, 0.1};
    world.models[1].links[0].collisions[0].surface.maxContacts = most;
    Rig rig(std::move(world));
    rig.step(300);
    std::vector<Contact> contacts;
    rig.engine.contacts(contacts);
    EXPECT_LE(contacts.size(), static_cast<std::size_t>(most));
    if (most == 0) continue;
    EXPECT_FALSE(contacts.empty());
    // those that stay bear it where it stands
    if (most < 6) continue;
    EXPECT_NEAR(rig.link("comb::link").X_WorldLink.position.z(), 0, 2e-4) << most;
    double left = 1, right = 0;
    for (const Contact& contact : contacts) {
      left = std::min(left, contact.position.x());
      right = std::max(right, contact.position.x());
    }
    EXPECT_LT(left, 0.06);
    EXPECT_GT(right, 0.89);
  }
}

}  // namespace
}  // namespace pongsim::physics
