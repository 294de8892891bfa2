#include "physics/shapes/shape.hh"

#include <gtest/gtest.h>

#include "sdf/readers/shapes/extrusion.hh"
#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using test::addCollision;
using test::makeLink;
using test::makeModel;
using test::Rig;

// height of the link's origin when it has come to rest on the ground
double restingHeight(const description::Link& link) {
  description::World world;
  world.models = {test::makeGround(), makeModel("body", {link})};
  Rig rig(std::move(world));
  rig.step(2000);
  EXPECT_LT(rig.link("body::link").v_WorldLink.norm(), 1e-3);
  return rig.link("body::link").X_WorldLink.position.z();
}

TEST(LinkShape, RestsAtItsOwnHalfHeight) {
  description::Link box = makeLink("link", {0, 0, 0.16}, 1, {0.01, 0.01, 0.01});
  addCollision(box, description::Box{{0.2, 0.2, 0.3}});
  EXPECT_NEAR(restingHeight(box), 0.15, 1e-5);

  description::Link sphere = makeLink("link", {0, 0, 0.26}, 1, {0.01, 0.01, 0.01});
  addCollision(sphere, description::Sphere{0.25});
  EXPECT_NEAR(restingHeight(sphere), 0.25, 1e-5);

  description::Link cylinder = makeLink("link", {0, 0, 0.11}, 1, {0.01, 0.01, 0.01});
  addCollision(cylinder, description::Cylinder{0.3, 0.2});
  EXPECT_NEAR(restingHeight(cylinder), 0.1, 1e-5);

  description::Link lying = makeLink("link", {0, 0, 0.31}, 1, {0.01, 0.01, 0.01});
  addCollision(lying, description::Cylinder{0.3, 0.2});
  lying.collisions[0].X_LinkCollision.rotation = fromRollPitchYaw(M_PI / 2, 0, 0);
  EXPECT_NEAR(restingHeight(lying), 0.3, 1e-5);
}

TEST(LinkShape, RestsAsACapsuleOrAnEllipsoid) {
  description::Link standing = makeLink("link", {0, 0, 0.61}, 1, {0.01, 0.01, 0.01});
  addCollision(standing, description::Ellipsoid{{1, 1, 0.6}});
  EXPECT_NEAR(restingHeight(standing), 0.6, 1e-4);

  description::Link lying = makeLink("link", {0, 0, 0.21}, 1, {0.01, 0.01, 0.01});
  addCollision(lying, description::Capsule{0.2, 0.6});
  lying.collisions[0].X_LinkCollision.rotation = fromRollPitchYaw(M_PI / 2, 0, 0);
  EXPECT_NEAR(restingHeight(lying), 0.2, 1e-4);
}

TEST(LinkShape, PutsEachCollisionWhereTheLinkHasIt) {
  // two feet below a link whose centre of mass lies off its origin
  description::Link link = makeLink("link", {0, 0, 0.51}, 1, {0.02, 0.03, 0.04});
  link.inertial.X_LinkCom = {{0.1, 0, -0.2}, fromRollPitchYaw(0.2, 0.1, 0.3)};
  for (double y : {-0.4, 0.4}) {
    addCollision(link, description::Box{{0.8, 0.1, 0.2}});
    link.collisions.back().X_LinkCollision.position = {0, y, -0.4};
  }
  EXPECT_NEAR(restingHeight(link), 0.5, 1e-5);
}

/// A ring with a square hole of 1 m, from z = 0 to 0.5.
description::Polyline ringOfPolylines() {
  description::Polyline ring;
  ring.lines = {{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};
  ring.height = 0.5;
  ring.triangles = sdf::extrude(ring.lines, ring.height);
  return ring;
}

TEST(LinkShape, OfAPolylineRestsOnItsFlatSide) {
  description::Link link = makeLink("link", {0, 0, 0.01}, 1, {1, 1, 1});
  link.inertial.X_LinkCom.position = {0, 0, 0.25};
  addCollision(link, ringOfPolylines());
  EXPECT_NEAR(restingHeight(link), 0, 1e-4);
}

TEST(LinkShape, OfAPolylineThatDoesNotMoveBearsAndHasItsHole) {
  description::Link ring = makeLink("link", {0, 0, 0}, 1, {1, 1, 1});
  addCollision(ring, ringOfPolylines());
  description::World world;
  world.models = {test::makeGround(), makeModel("ring", {ring})};
  world.models.back().isStatic = true;
  for (const double x : {0.0, 1.2}) {
    description::Link ball = makeLink("link", {x, 0, 1}, 1, {0.01, 0.01, 0.01});
    addCollision(ball, description::Sphere{0.2});
    world.models.push_back(makeModel(x == 0 ? "within" : "upon", {ball}));
  }
  Rig rig(std::move(world));
  rig.step(2000);
  EXPECT_NEAR(rig.link("within::link").X_WorldLink.position.z(), 0.2, 1e-3);
  EXPECT_NEAR(rig.link("upon::link").X_WorldLink.position.z(), 0.7, 1e-3);
}

TEST(LinkShape, LeavesOutWhatItCannotBuild) {
  description::Link link = makeLink("link", {0, 0, 0}, 1, {1, 1, 1});
  addCollision(link, description::Image{});
  addCollision(link, description::Empty{});
  addCollision(link, description::Mesh{});
  HullStore hulls;
  SharedShapes shared;
  EXPECT_TRUE(LinkShape(link, Pose(), true, hulls, shared).empty());
  EXPECT_NE(LinkShape(link, Pose(), true, hulls, shared).root(), nullptr);
}

}  // namespace
}  // namespace pongsim::physics
