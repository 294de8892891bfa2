// Free bodies, contacts and friction, compared with mechanics. The tolerances are those that are documented; the XML
// output has the deviations.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

// of the boxes benchmark of the Gazebo team: S. Peters and J. Hsu, Comparison of rigid body dynamic simulators for
// robotic simulation in Gazebo, ROSCon 2014
const Vector3 kBoxSize(0.1, 0.4, 0.9);
constexpr double kBoxMass = 10;

struct BoxErrors {
  double position = 0;
  double energy = 0;
  double momentum = 0;
};

/// Largest errors in 10 s: of the position [m], and of energy and angular momentum relative to the start.
BoxErrors freeBoxErrors(double step, bool isComplex) {
  const Vector3 gravity(0, 0, isComplex ? -9.8 : 0);
  const Vector3 v = isComplex ? Vector3(-2, 2, 8) : Vector3(-0.9, 0.4, 0.1);
  const Vector3 w = isComplex ? Vector3(0.1, 5, 0.1) : Vector3(0.5, 0, 0);
  const Vector3 moments = test::boxMoments(kBoxMass, kBoxSize);
  description::World world;
  world.gravity = gravity;
  world.models = {test::makeModel("box", {test::makeLink("link", {0, 0, 0}, kBoxMass, moments)})};
  test::Rig rig(std::move(world));
  rig.engine.setLinkVelocity(0, v, w);
  const auto energyOf = [&](const world::LinkState& link) {
    const Vector3 turn = link.X_WorldLink.rotation.conjugate() * link.w_WorldLink;
    return kBoxMass * link.v_WorldLink.squaredNorm() / 2 + turn.cwiseProduct(moments).dot(turn) / 2 -
           kBoxMass * gravity.dot(link.X_WorldLink.position);
  };
  const auto momentumOf = [&](const world::LinkState& link) -> Vector3 {
    const Quaternion& q = link.X_WorldLink.rotation;
    return q * moments.cwiseProduct(q.conjugate() * link.w_WorldLink);
  };
  world::LinkState start;
  start.v_WorldLink = v;
  start.w_WorldLink = w;
  const double energy = energyOf(start);
  const Vector3 momentum = momentumOf(start);
  BoxErrors errors;
  const int steps = static_cast<int>(std::lround(10 / step));
  for (int i = 1; i <= steps; ++i) {
    rig.engine.step(fromSeconds(step), rig.state);
    const world::LinkState& link = rig.link("box::link");
    const double t = i * step;
    errors.position = std::max(errors.position, (link.X_WorldLink.position - (v * t + gravity * t * t / 2)).norm());
    errors.energy = std::max(errors.energy, std::abs(energyOf(link) / energy - 1));
    errors.momentum = std::max(errors.momentum, (momentumOf(link) - momentum).norm() / momentum.norm());
  }
  return errors;
}

void record(const std::string& name, double value) {
  testing::Test::RecordProperty(name, std::to_string(value * 1e6) + "e-6");
}

TEST(AnalyticBodies, FallFreely) {
  description::World world;
  world.gravity = {0, 0, -9.8};
  world.models = {test::makeModel("ball", {test::makeLink("link", {0, 0, 100}, 1, {1, 1, 1})})};
  test::Rig rig(std::move(world));
  rig.step(2000);
  const world::LinkState& ball = rig.link("ball::link");
  // semi-implicit Euler: g h^2 n (n + 1) / 2
  EXPECT_NEAR(ball.X_WorldLink.position.z(), 100 - 9.8 * 1e-6 * 2000 * 2001 / 2, 1e-9);
  EXPECT_NEAR(ball.v_WorldLink.z(), -19.6, 1e-10);
}

TEST(AnalyticBodies, KeepEnergyAndMomentumOfTheBoxesBenchmark) {
  for (const double step : {0.0005, 0.001, 0.002, 0.004, 0.01}) {
    for (const bool isComplex : {false, true}) {
      const BoxErrors errors = freeBoxErrors(step, isComplex);
      const std::string name = std::string(isComplex ? "complex_" : "simple_") + std::to_string(step);
      record(name + "_position", errors.position);
      record(name + "_energy", errors.energy);
      record(name + "_momentum", errors.momentum);
      EXPECT_LT(errors.position, isComplex ? 51 * step : 1e-10) << name;
      EXPECT_LT(errors.energy, isComplex ? 14 * step : 1e-9) << name;
      EXPECT_LT(errors.momentum, isComplex ? 2 * step : 1e-9) << name;
    }
  }
}

TEST(AnalyticBodies, FlipAboutTheIntermediateAxis) {
  // Dzhanibekov: turning about the middle one of three moments, it turns over and back; about the others it does not
  const Vector3 moments(1, 2, 3);
  const auto flips = [&](int axis) {
    description::World world;
    world.gravity.setZero();
    world.models = {test::makeModel("body", {test::makeLink("link", {0, 0, 0}, 1, moments)})};
    test::Rig rig(std::move(world));
    Vector3 w = Vector3::Constant(0.01);
    w[axis] = 3;
    rig.engine.setLinkVelocity(0, {0, 0, 0}, w);
    int count = 0;
    bool isOver = false;
    for (int i = 0; i < 20000; ++i) {
      rig.step();
      const Vector3 up = rig.link("body::link").X_WorldLink.rotation * Vector3::Unit(axis);
      const bool isNow = up[axis] < 0;
      if (isNow != isOver) ++count;
      isOver = isNow;
    }
    return count;
  };
  EXPECT_EQ(flips(0), 0);
  EXPECT_GE(flips(1), 2);
  EXPECT_EQ(flips(2), 0);
}

TEST(AnalyticBodies, BounceAsHighAsRestitutionSays) {
  description::Link link = test::makeLink("link", {0, 0, 1.1}, 1, {0.004, 0.004, 0.004});
  test::addCollision(link, description::Sphere{0.1});
  description::Model ground = test::makeGround();
  link.collisions[0].surface.restitution = 0.8;
  ground.links[0].collisions[0].surface.restitution = 1;
  description::World world;
  world.gravity = {0, 0, -9.8};
  world.models = {ground, test::makeModel("ball", {link})};
  test::Rig rig(std::move(world));
  std::vector<double> heights;
  double before = 0;
  for (int i = 0; i < 3000; ++i) {
    const double speed = rig.link("ball::link").v_WorldLink.z();
    rig.step();
    if (speed > 0 && rig.link("ball::link").v_WorldLink.z() <= 0) heights.push_back(before - 0.1);
    before = rig.link("ball::link").X_WorldLink.position.z();
  }
  ASSERT_GE(heights.size(), 3U);
  double expected = 1;
  for (int i = 0; i < 3; ++i) {
    expected *= 0.64;
    record("bounce_" + std::to_string(i), heights[static_cast<std::size_t>(i)] / expected - 1);
    EXPECT_NEAR(heights[static_cast<std::size_t>(i)], expected, 0.01 * expected) << i;
  }
}

TEST(AnalyticBodies, RestInAStackOfTenForAMinute) {
  const Vector3 size(0.5, 0.5, 0.2);
  description::World world;
  world.models = {test::makeGround()};
  for (int i = 0; i < 10; ++i) {
    description::Link link = test::makeLink("link", {0, 0, 0.1 + 0.2 * i}, 1, test::boxMoments(1, size));
    test::addCollision(link, description::Box{size});
    world.models.push_back(test::makeModel("box" + std::to_string(i), {link}));
  }
  test::Rig rig(std::move(world));
  const auto run = [&](int seconds) {
    for (int i = 0; i < 200 * seconds; ++i) rig.engine.step(std::chrono::milliseconds(5), rig.state);
  };
  run(1);
  std::vector<Vector3> settled;
  for (std::size_t i = 1; i <= 10; ++i) settled.push_back(rig.state.links[i].X_WorldLink.position);
  run(59);
  double drift = 0;
  for (std::size_t i = 1; i <= 10; ++i) {
    drift = std::max(drift, (rig.state.links[i].X_WorldLink.position - settled[i - 1]).norm());
    EXPECT_LT((rig.state.links[i].X_WorldLink.position - Vector3(0, 0, 0.2 * static_cast<double>(i) - 0.1)).norm(),
              1e-3);
  }
  record("drift", drift);
  EXPECT_LT(drift, 1e-6);
}

TEST(AnalyticBodies, RollAsFarAsTheyTurn) {
  description::Link link = test::makeLink("link", {0, 0, 0.25}, 2, {0.05, 0.05, 0.0625});
  link.X_ModelLink.rotation = fromRollPitchYaw(-M_PI / 2, 0, 0);
  test::addCollision(link, description::Cylinder{0.25, 0.1});
  description::World world;
  world.gravity = {0, 0, -9.8};
  world.models = {test::makeGround(), test::makeModel("wheel", {link})};
  test::Rig rig(std::move(world));
  rig.step(100);
  rig.engine.setLinkVelocity(1, {0.5, 0, 0}, {0, 2, 0});
  const double start = rig.link("wheel::link").X_WorldLink.position.x();
  double angle = 0;
  while (angle < 2 * M_PI) {
    rig.step();
    angle += rig.link("wheel::link").w_WorldLink.y() * 1e-3;
  }
  const double distance = rig.link("wheel::link").X_WorldLink.position.x() - start;
  record("rolled", distance / (angle * 0.25) - 1);
  EXPECT_NEAR(distance, angle * 0.25, 1e-3 * angle * 0.25);
}

}  // namespace
}  // namespace pongsim::physics
