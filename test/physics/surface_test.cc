#include "physics/surface.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/rig.hh"

namespace pongsim::physics {
namespace {

using test::addCollision;
using test::makeLink;
using test::makeModel;
using test::Rig;

constexpr double kSurfaceGravity = 9.8;

// a block on a slope about y; the slope's friction is above any that the block has
Rig blockOnSlope(double angle, double mu, double mass = 2) {
  const Quaternion tilt = fromRollPitchYaw(0, angle, 0);
  const Vector3 size(0.4, 0.4, 0.2);
  description::Link link = makeLink("link", {0, 0, 0.1}, mass, test::boxMoments(mass, size));
  addCollision(link, description::Box{size}, mu);
  description::Model block = makeModel("block", {link});
  block.X_ParentModel.rotation = tilt;
  description::World world;
  world.gravity = {0, 0, -kSurfaceGravity};
  world.models = {test::makeGround(5, tilt * Vector3::UnitZ()), block};
  return Rig(std::move(world));
}

TEST(Surface, HoldsABlockBelowTheFrictionAngle) {
  Rig rig = blockOnSlope(std::atan(0.45), 0.5);
  rig.step(5000);
  EXPECT_LT((rig.link("block::link").X_WorldLink.position).norm(), 0.1 + 1e-3);
  EXPECT_LT(rig.link("block::link").v_WorldLink.norm(), 1e-5);
}

TEST(Surface, HoldsAHeavyBlockAsWell) {
  Rig rig = blockOnSlope(std::atan(0.45), 0.5, 500);
  rig.step(5000);
  EXPECT_LT(rig.link("block::link").v_WorldLink.norm(), 1e-4);
}

TEST(Surface, LetsABlockSlideAboveTheFrictionAngleByCoulombsLaw) {
  const double angle = std::atan(0.7);
  Rig rig = blockOnSlope(angle, 0.5);
  rig.step(1000);
  const double acceleration = kSurfaceGravity * (std::sin(angle) - 0.5 * std::cos(angle));
  EXPECT_NEAR(rig.link("block::link").v_WorldLink.norm(), acceleration, 0.01 * acceleration);
}

TEST(Surface, MultipliesRestitution) {
  // the first step, at 1 m/s, takes it down to where it just touches
  description::Link link = makeLink("link", {0, 0, 0.101}, 1, {0.01, 0.01, 0.01});
  addCollision(link, description::Sphere{0.1});
  link.collisions[0].surface.restitution = 0.8;
  description::Model ground = test::makeGround();
  ground.links[0].collisions[0].surface.restitution = 0.5;
  description::World world;
  world.gravity.setZero();
  world.models = {ground, makeModel("ball", {link})};
  Rig rig(std::move(world));
  rig.engine.addLinkWrench(1, {0, 0, -1000}, {0, 0, 0});
  rig.step(2);
  // but for the softness of contacts, 1e-4 of the change in speed
  EXPECT_NEAR(rig.link("ball::link").v_WorldLink.z(), 0.4, 3e-4);
}

}  // namespace
}  // namespace pongsim::physics
