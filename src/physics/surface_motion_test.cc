// Moving surfaces, such as belts and tracks, compared with mechanics.

#include "pongsim/geometry/surface_motion.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "physics/engine.hh"
#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using test::addCollision;
using test::makeLink;
using test::makeModel;
using test::Rig;

constexpr double kBeltGravity = 9.8;
constexpr world::Slot kBelt = 0, kBox = 1;

// a belt that rises towards +x by `slope`, with a crate on it
Rig crateOnBelt(double mu, double slope = 0, const Settings& settings = Settings(),
                const Vector3& size = {0.2, 0.2, 0.1}) {
  description::Link belt = makeLink("link", {0, 0, -0.05}, 1, {1, 1, 1});
  addCollision(belt, description::Box{{40, 40, 0.1}}, 5);
  belt.collisions[0].surface.mu2 = 5;
  description::Model fixed = makeModel("belt", {belt});
  fixed.isStatic = true;
  fixed.X_ParentModel.rotation = fromRollPitchYaw(0, -slope, 0);
  description::Link crate = makeLink("link", {0, 0, 0.05}, 2, test::boxMoments(2, size));
  addCollision(crate, description::Box{size}, mu);
  crate.collisions[0].surface.mu2 = mu;
  description::Model box = makeModel("crate", {crate});
  box.X_ParentModel.rotation = fixed.X_ParentModel.rotation;
  description::World world;
  world.gravity = {0, 0, -kBeltGravity};
  world.models = {fixed, box};
  return Rig(std::move(world), settings);
}

const world::LinkState& crateOf(const Rig& rig) { return rig.state.links[kBox]; }

TEST(SurfaceMotion, CarriesACrateAtTheSpeedOfTheBelt) {
  for (const Solver solver : {Solver::kDirect, Solver::kGaussSeidel}) {
    for (const double speed : {0.5, -2.0}) {
      Rig rig = crateOnBelt(0.5, 0, {.solver = solver});
      rig.engine.setSurfaceMotion(kBelt, 0, SurfaceMotion{.speed = speed});
      rig.step(1000);
      EXPECT_NEAR(crateOf(rig).v_WorldLink.x(), speed, 1e-3 * std::abs(speed));
      EXPECT_NEAR(crateOf(rig).v_WorldLink.y(), 0, 1e-6);
      EXPECT_NEAR(crateOf(rig).X_WorldLink.position.z(), 0.05, 1e-3);
      // boxes that move over each other rock by some micrometres
      EXPECT_LT(crateOf(rig).w_WorldLink.norm(), 0.1);
    }
  }
}

TEST(SurfaceMotion, GivesNoMoreSpeedThanFrictionCan) {
  Rig rig = crateOnBelt(0.2);
  rig.step(10);
  rig.engine.setSurfaceMotion(kBelt, 0, SurfaceMotion{.speed = 3});
  rig.step(1000);
  EXPECT_NEAR(crateOf(rig).v_WorldLink.x(), 0.2 * kBeltGravity, 0.002 * 0.2 * kBeltGravity);
  rig.step(1000);
  // 3 m/s are reached after 1.53 s
  EXPECT_NEAR(crateOf(rig).v_WorldLink.x(), 3, 3e-3);
}

TEST(SurfaceMotion, CarriesUphillBelowTheFrictionAngleAndSlipsAboveIt) {
  const double slope = std::atan(0.45);
  Rig steep = crateOnBelt(0.5, slope);
  steep.engine.setSurfaceMotion(kBelt, 0, SurfaceMotion{.speed = 0.4});
  // with 0.05 of the weight to spare it takes 0.9 s
  steep.step(2000);
  const Vector3 up(std::cos(slope), 0, std::sin(slope));
  EXPECT_NEAR(crateOf(steep).v_WorldLink.dot(up), 0.4, 4e-3);

  const double tooSteep = std::atan(0.7);
  Rig rig = crateOnBelt(0.5, tooSteep);
  rig.engine.setSurfaceMotion(kBelt, 0, SurfaceMotion{.speed = 0.4});
  rig.step(1000);
  const double acceleration = kBeltGravity * (std::sin(tooSteep) - 0.5 * std::cos(tooSteep));
  EXPECT_NEAR(crateOf(rig).v_WorldLink.norm(), acceleration, 0.01 * acceleration);
}

TEST(SurfaceMotion, GoesRoundACentreAtTheRadiusWhereTheCrateLies) {
  constexpr double kRadius = 2, kSpeed = 0.5;
  // long enough to turn with the belt, whose points push it at one speed wherever they are
  Rig rig = crateOnBelt(0.8, 0, Settings(), {0.4, 0.1, 0.1});
  // the crate lies at the origin; the way round nearer to +x is anticlockwise
  const Vector3 center(0, kRadius, 0);
  rig.engine.setSurfaceMotion(kBelt, 0, SurfaceMotion{.speed = kSpeed, .center = center});
  rig.step(500);
  double farthest = 0, nearest = 10, way = 0, turned = 0;
  world::LinkState last = crateOf(rig);
  for (int i = 0; i < 6000; ++i) {
    rig.step();
    const world::LinkState& now = crateOf(rig);
    const double radius = (now.X_WorldLink.position - center).head<2>().norm();
    farthest = std::max(farthest, radius);
    nearest = std::min(nearest, radius);
    way += (now.X_WorldLink.position - last.X_WorldLink.position).norm();
    turned += std::remainder(yawOf(now.X_WorldLink.rotation) - yawOf(last.X_WorldLink.rotation), 2 * M_PI);
    last = now;
  }
  EXPECT_NEAR(farthest, kRadius, 0.01 * kRadius);
  EXPECT_NEAR(nearest, kRadius, 0.01 * kRadius);
  // the crate turns with its way round
  EXPECT_NEAR(turned, way / kRadius, 0.005 * way / kRadius);
  // its points lie at several radii, and the belt's speed is the same at all: that of some of them is met
  const double inner = std::hypot(kRadius - 0.05, 0.2), outer = std::hypot(kRadius + 0.05, 0.2);
  EXPECT_GT(last.v_WorldLink.norm(), 0.999 * kSpeed * kRadius / outer);
  EXPECT_LT(last.v_WorldLink.norm(), 1.001 * kSpeed * kRadius / inner);
}

TEST(SurfaceMotion, RunsBackwardsBelowWhereItRunsForwardsAbove) {
  // the crate's own surface runs: it drives
  Rig rig = crateOnBelt(0.5);
  rig.engine.setSurfaceMotion(kBox, 0, SurfaceMotion{.speed = 0.5});
  rig.step(1000);
  EXPECT_NEAR(crateOf(rig).v_WorldLink.x(), 0.5, 5e-4);
}

TEST(SurfaceMotion, AddsUpWhereBothSurfacesRun) {
  Rig rig = crateOnBelt(0.5);
  rig.engine.setSurfaceMotion(kBox, 0, SurfaceMotion{.speed = 0.5});
  rig.engine.setSurfaceMotion(kBelt, 0, SurfaceMotion{.speed = 0.3});
  rig.step(1000);
  EXPECT_NEAR(crateOf(rig).v_WorldLink.x(), 0.8, 1e-3);
  // one of them across
  rig.engine.setSurfaceMotion(kBelt, 0, SurfaceMotion{.speed = 0.3, .axis = {-2, 0, 0}});
  rig.step(1000);
  EXPECT_NEAR(crateOf(rig).v_WorldLink.x(), 0.5, 1e-3);
  EXPECT_NEAR(crateOf(rig).v_WorldLink.y(), 0.3, 1e-3);
}

TEST(SurfaceMotion, EndsWhenItIsTold) {
  Rig rig = crateOnBelt(0.5);
  rig.engine.setSurfaceMotion(kBelt, 0, SurfaceMotion{.speed = 0.5});
  rig.step(500);
  rig.engine.setSurfaceMotion(kBelt, 0, std::nullopt);
  EXPECT_EQ(rig.engine.surfaceMotion(kBelt, 0), std::nullopt);
  rig.step(500);
  EXPECT_LT(crateOf(rig).v_WorldLink.norm(), 1e-4);
}

TEST(SurfaceMotion, RubsWithTheFirstCoefficientAlongAndTheSecondAcross) {
  const auto accelerations = [](const Vector3& axis) {
    Rig rig = crateOnBelt(0.4);
    rig.engine.setSurfaceMotion(kBelt, 0, SurfaceMotion{.speed = 100, .axis = axis});
    rig.step(500);
    return 2 * crateOf(rig).v_WorldLink.norm() / kBeltGravity;
  };
  EXPECT_NEAR(accelerations({0, 1, 0}), 0.4, 0.004);
  EXPECT_NEAR(accelerations({-1, 1, 0}), 0.4, 0.004) << "a pyramid along the motion: no more in any direction";
}

TEST(SurfaceMotion, DoesNotRunOnItsSides) {
  // lies on its side: the axis of the drums points up
  Rig rig = crateOnBelt(0.5);
  rig.engine.setSurfaceMotion(kBelt, 0, SurfaceMotion{.speed = 0.5, .axis = {0, 0, 1}});
  rig.step(500);
  EXPECT_LT(crateOf(rig).v_WorldLink.norm(), 1e-4);
}

TEST(SurfaceMotion, GivesBackTheAxisInTheLinkFrame) {
  description::Link link = makeLink("link", {0, 0, 1}, 1, {1, 2, 3});
  link.inertial.X_LinkCom.rotation = fromRollPitchYaw(0.3, 0.4, 0.5);
  addCollision(link, description::Box{{1, 1, 1}});
  description::World world;
  world.models = {makeModel("m", {link})};
  Rig rig(std::move(world));
  rig.engine.setSurfaceMotion(0, 0, SurfaceMotion{.speed = 1, .axis = {0, 0, 3}, .center = Vector3(1, 2, 3)});
  const std::optional<SurfaceMotion> motion = rig.engine.surfaceMotion(0, 0);
  ASSERT_TRUE(motion);
  EXPECT_LT((motion->axis - Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_EQ(motion->center, Vector3(1, 2, 3));
}

TEST(SurfaceMotion, MakesTheSameBitsWithAnyNumberOfThreads) {
  std::optional<std::uint64_t> hash;
  for (const int threads : {1, 2, 4}) {
    description::Link belt = makeLink("link", {0, 0, -0.05}, 1, {1, 1, 1});
    addCollision(belt, description::Box{{40, 40, 0.1}});
    description::World world;
    world.models = {makeModel("belt", {belt})};
    world.models[0].isStatic = true;
    for (int i = 0; i < 12; ++i) {
      description::Link crate = makeLink("link", {0.5 * i, 0.02 * i, 0.1 + 0.01 * i}, 2, {0.02, 0.02, 0.02});
      addCollision(crate, description::Box{{0.2, 0.2, 0.1}});
      world.models.push_back(makeModel("crate" + std::to_string(i), {crate}));
    }
    Rig rig(std::move(world), {.threads = threads});
    rig.engine.setSurfaceMotion(kBelt, 0, SurfaceMotion{.speed = 0.7, .center = Vector3(1, 3, 0)});
    rig.step(600);
    const std::uint64_t found = world::stateHash(rig.state);
    EXPECT_EQ(found, hash.value_or(found)) << threads;
    hash = found;
  }
}

TEST(Slip, CanBeSetWhileRunning) {
  Rig rig = crateOnBelt(1);
  EXPECT_EQ(rig.engine.slip(kBox, 0), std::pair(0.0, 0.0));
  rig.engine.setSlip(kBox, 0, 0.08, 0.16);
  EXPECT_EQ(rig.engine.slip(kBox, 0), std::pair(0.08, 0.16));
  for (int i = 0; i < 500; ++i) {
    // along x, the first direction, and across; at the height of the floor, so that it does not tip
    const Vector3 force(1, 1, 0);
    rig.engine.addLinkWrench(kBox, force, Vector3(0, 0, -0.05).cross(force));
    rig.step();
  }
  // shared out among four points
  EXPECT_NEAR(crateOf(rig).v_WorldLink.x(), 0.02, 5e-4);
  EXPECT_NEAR(crateOf(rig).v_WorldLink.y(), 0.04, 5e-4);
}

// A wheel, turned by a quarter or by nothing about its own axis, on a hub that does not turn.
TEST(FrictionDirection, IsFixedToTheLinkThatFdir1IsExpressedIn) {
  const auto speedAlong = [](double turn, bool isExpressedInHub) {
    description::Link hub = makeLink("hub", {0, 0, 0.1}, 2, {0.1, 0.1, 0.1});
    description::Link wheel = makeLink("wheel", {0, 0, 0.1}, 2, {0.1, 0.1, 0.1});
    addCollision(wheel, description::Sphere{0.1}, 1);
    wheel.collisions[0].surface.mu2 = 0;
    wheel.collisions[0].surface.fdir1 = {0, 1, 0};
    if (isExpressedInHub) wheel.collisions[0].surface.fdir1Link = "hub";
    // its frame lies on its side, and has been turned about its axis, y of the world
    wheel.X_ModelLink.rotation = fromRollPitchYaw(0, turn, 0) * fromRollPitchYaw(-M_PI / 2, 0, 0);
    description::Model model = makeModel("m", {hub, wheel});
    model.joints.push_back(test::makeJoint("fixed", description::JointType::kFixed, "hub", "wheel", Pose(),
                                           Pose{{0, 0, 0}, wheel.X_ModelLink.rotation.conjugate()}));
    description::World world;
    world.gravity = {0, 0, -kBeltGravity};
    world.models = {test::makeGround(), model};
    Rig rig(std::move(world));
    // held upright, pushed along y, the axis of the wheel
    for (int i = 0; i < 200; ++i) {
      rig.engine.addLinkWrench(1, {0, 4, 0}, {0, 0, 0});
      rig.engine.setLinkVelocity(1, rig.link("m::hub").v_WorldLink, {0, 0, 0});
      rig.engine.setLinkVelocity(2, rig.link("m::wheel").v_WorldLink, {0, 0, 0});
      rig.step();
    }
    return rig.link("m::hub").v_WorldLink.y();
  };
  // mu 1 along the axis holds it, however the wheel has turned
  EXPECT_NEAR(speedAlong(0, true), 0, 0.02);
  EXPECT_NEAR(speedAlong(1, true), 0, 0.02);
  // in its own frame y points back and down by now, and what rubs is along x
  EXPECT_NEAR(speedAlong(1, false), 0.2, 0.01);
}

}  // namespace
}  // namespace pongsim::physics
