#include "physics/contacts/surface.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "support/physics/rig.hh"

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

// a block on the floor, its surface as given, after half a second of pushing
world::LinkState pushedBlock(const description::Surface& surface, const Vector3& force, double yaw = 0) {
  const Vector3 size(0.4, 0.4, 0.1);
  description::Link link = makeLink("link", {0, 0, 0.05}, 2, test::boxMoments(2, size));
  addCollision(link, description::Box{size});
  link.collisions[0].surface = surface;
  description::Model block = makeModel("block", {link});
  block.X_ParentModel.rotation = fromRollPitchYaw(0, 0, yaw);
  description::Model ground = test::makeGround(5);
  ground.links[0].collisions[0].surface.mu2 = 5;
  description::World world;
  world.gravity = {0, 0, -kSurfaceGravity};
  world.models = {ground, block};
  Rig rig(std::move(world));
  for (int i = 0; i < 500; ++i) {
    // at half the height of the centre, so that it does not tip
    rig.engine.addLinkWrench(1, force, Vector3(0, 0, -0.05).cross(force));
    rig.step();
  }
  return rig.link("block::link");
}

TEST(Surface, RubsByDirectionAsFdir1Says) {
  description::Surface surface;
  surface.mu = 0.2;
  surface.mu2 = 0.8;
  surface.fdir1 = {1, 0, 0};
  const double force = 0.5 * 2 * kSurfaceGravity;
  const double speed = 0.5 * (0.5 - 0.2) * kSurfaceGravity;
  struct Push {
    Vector3 direction;
    double yaw;
    bool slides;
  };
  for (const Push& push : {Push{{1, 0, 0}, 0, true}, Push{{0, 1, 0}, 0, false}, Push{{0, 1, 0}, M_PI / 2, true},
                           Push{{1, 0, 0}, M_PI / 2, false}}) {
    const double found = pushedBlock(surface, force * push.direction, push.yaw).v_WorldLink.dot(push.direction);
    EXPECT_NEAR(found, push.slides ? speed : 0, push.slides ? 0.02 * speed : 1e-3)
        << push.direction.transpose() << ", " << push.yaw;
  }
}

TEST(Surface, TakesTheWorldsAxesWhereNoDirectionIsGiven) {
  description::Surface surface;
  surface.mu = 0.2;
  surface.mu2 = 0.8;
  EXPECT_GT(pushedBlock(surface, {9.8, 0, 0}, 0.7).v_WorldLink.x(), 1);
  EXPECT_LT(pushedBlock(surface, {0, 9.8, 0}, 0.7).v_WorldLink.y(), 1e-3);
}

TEST(Surface, SlipsByTheForceOnIt) {
  description::Surface surface;
  surface.fdir1 = {1, 0, 0};
  surface.slip1 = 0.08;
  // 1 N on four points
  EXPECT_NEAR(pushedBlock(surface, {1, 0, 0}).v_WorldLink.x(), 0.08 / 4, 5e-4);
  EXPECT_NEAR(pushedBlock(surface, {0, 1, 0}).v_WorldLink.y(), 0, 5e-4);
}

TEST(Surface, TouchesWhereTheMasksShareABit) {
  // a ball and a box in one link; the shelf is for the box only
  description::Link link = makeLink("link", {0, 0, 2}, 1, {0.1, 0.1, 0.1});
  addCollision(link, description::Sphere{0.1});
  addCollision(link, description::Box{{0.2, 0.2, 0.2}});
  link.collisions[0].surface.collideBitmask = 1;
  link.collisions[1].surface.collideBitmask = 2;
  link.collisions[1].X_LinkCollision.position.z() = 0.5;
  description::Link shelf = makeLink("link", {0, 0, 1}, 1, {1, 1, 1});
  addCollision(shelf, description::Box{{1, 1, 0.1}});
  for (const auto& [mask, height] : {std::pair{1, 1.15}, std::pair{2, 0.65}, std::pair{4, 0.1}}) {
    shelf.collisions[0].surface.collideBitmask = static_cast<std::uint16_t>(mask);
    description::World world;
    description::Model fixed = makeModel("shelf", {shelf});
    fixed.isStatic = true;
    world.models = {test::makeGround(), fixed, makeModel("model", {link})};
    Rig rig(std::move(world));
    rig.step(1000);
    EXPECT_NEAR(rig.link("model::link").X_WorldLink.position.z(), height, 5e-3) << mask;
  }
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

// a ball of 2 kg and 0.1 m on a floor, both surfaces as given
Rig ballOnFloor(const description::Surface& ball, const description::Surface& floor, Solver solver = Solver::kDirect) {
  description::Link link = makeLink("link", {0, 0, 0.1}, 2, {0.008, 0.008, 0.008});
  addCollision(link, description::Sphere{0.1});
  link.collisions[0].surface = ball;
  description::Model ground = test::makeGround();
  ground.links[0].collisions[0].surface = floor;
  description::World world;
  world.gravity = {0, 0, -kSurfaceGravity};
  world.models = {ground, makeModel("ball", {link})};
  Settings settings;
  settings.solver = solver;
  return Rig(std::move(world), settings);
}

TEST(Surface, ResistsTurningAboutTheNormalByTheSizeOfThePatch) {
  description::Surface ball, floor;
  ball.torsion = {0.5, 0.02, 0, true, 0};
  // the larger patch and the smaller coefficient count
  floor.torsion = {0.8, 0.01, 0, true, 0};
  for (const Solver solver : {Solver::kDirect, Solver::kGaussSeidel}) {
    Rig rig = ballOnFloor(ball, floor, solver);
    rig.step(200);
    rig.engine.setLinkVelocity(1, {0, 0, 0}, {0, 0, 20});
    rig.step(300);
    const double slowing = 3 * M_PI / 16 * 0.02 * 0.5 * 2 * kSurfaceGravity / 0.008;
    EXPECT_NEAR(20 - rig.link("ball::link").w_WorldLink.z(), 0.3 * slowing, 0.003 * slowing);
    // and then it stands
    rig.step(2000);
    EXPECT_NEAR(rig.link("ball::link").w_WorldLink.z(), 0, 1e-4);
  }
  Rig free = ballOnFloor({}, {});
  free.engine.setLinkVelocity(1, {0, 0, 0}, {0, 0, 20});
  free.step(500);
  EXPECT_NEAR(free.link("ball::link").w_WorldLink.z(), 20, 1e-6);
}

TEST(Surface, TurnsOnBySlip) {
  description::Surface ball;
  ball.torsion = {1, 0.1, 0, true, 4};
  Rig rig = ballOnFloor(ball, {});
  rig.step(100);
  for (int i = 0; i < 1000; ++i) {
    rig.engine.addLinkWrench(1, {0, 0, 0}, {0, 0, 0.5});
    rig.step();
  }
  EXPECT_NEAR(rig.link("ball::link").w_WorldLink.z(), 4 * 0.5, 1e-3);
}

TEST(Surface, BouncesFromItsThresholdOn) {
  description::Surface ball, floor;
  ball.restitution = floor.restitution = 1;
  const auto speedAfter = [&](double speed) {
    Rig rig = ballOnFloor(ball, floor);
    rig.engine.setGravity({0, 0, 0});
    rig.engine.setLinkVelocity(1, {0, 0, -speed}, {0, 0, 0});
    rig.step(2);
    return rig.link("ball::link").v_WorldLink.z();
  };
  EXPECT_NEAR(speedAfter(0.2), 0.2, 1e-3);
  EXPECT_NEAR(speedAfter(0.09), 0, 1e-3);
  ball.bounceThreshold = 0.5;
  EXPECT_NEAR(speedAfter(0.4), 0, 1e-3);
  EXPECT_NEAR(speedAfter(0.6), 0.6, 1e-3);
  // of two the smaller one
  floor.bounceThreshold = 0.05;
  EXPECT_NEAR(speedAfter(0.06), 0.06, 1e-3);
}

TEST(Surface, TouchesAtNoMorePointsThanAllowed) {
  const auto points = [](std::optional<long long> own, long long ofWorld) {
    description::Link link = makeLink("link", {0, 0, 0.1}, 2, {0.1, 0.1, 0.1});
    addCollision(link, description::Box{{0.4, 0.4, 0.2}});
    link.collisions[0].surface.maxContacts = own;
    description::World world;
    world.gravity = {0, 0, -kSurfaceGravity};
    world.models = {test::makeGround(), makeModel("box", {link})};
    Settings settings;
    settings.maxContacts = ofWorld;
    Rig rig(std::move(world), settings);
    rig.step(5);
    std::vector<Contact> contacts;
    rig.engine.contacts(contacts);
    return contacts.size();
  };
  EXPECT_EQ(points(std::nullopt, 20), 4U);
  EXPECT_EQ(points(std::nullopt, 3), 3U);
  EXPECT_EQ(points(2, 3), 2U);
  EXPECT_EQ(points(4, 3), 4U);
  EXPECT_EQ(points(std::nullopt, 0), 0U);
  EXPECT_EQ(points(std::nullopt, -1), 4U);
}

}  // namespace
}  // namespace pongsim::physics
