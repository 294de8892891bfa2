// Bodies on joints, compared with mechanics. The tolerances are those that are documented; the XML output has the
// deviations.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using description::JointType;

constexpr double kG = 9.8;

void note(const std::string& name, double value) {
  testing::Test::RecordProperty(name, std::to_string(value * 1e6) + "e-6");
}

double energyOf(const test::Rig& rig, const std::vector<world::Slot>& links) {
  double energy = 0;
  for (const world::Slot slot : links) {
    const description::Inertial& inertial = rig.entities.links()[slot].description->inertial;
    const world::LinkState& link = rig.state.links[slot];
    const Vector3 turn = link.X_WorldLink.rotation.conjugate() * link.w_WorldLink;
    energy += inertial.mass * (link.v_WorldLink.squaredNorm() / 2 + kG * link.X_WorldLink.position.z()) +
              turn.dot(inertial.moments * turn) / 2;
  }
  return energy;
}

// rods of 1 m and 1 kg, the first attached to the world, all level at the start
description::World pendulum(int count) {
  std::vector<description::Link> rods;
  for (int i = 0; i < count; ++i) {
    rods.push_back(test::makeLink("rod" + std::to_string(i), {0.5 + i, 0, 0}, 1, {0.01, 1.0 / 12, 1.0 / 12}));
  }
  description::Model model = test::makeModel("pendulum", rods);
  for (int i = 0; i < count; ++i) {
    const Pose inParent = i == 0 ? Pose() : test::at(0.5, 0, 0);
    model.joints.push_back(test::makeJoint("j" + std::to_string(i), JointType::kRevolute,
                                           i == 0 ? "world" : "rod" + std::to_string(i - 1), "rod" + std::to_string(i),
                                           inParent, test::at(-0.5, 0, 0), Vector3::UnitY()));
  }
  description::World world;
  world.gravity = {0, 0, -kG};
  world.models = {model};
  return world;
}

/// Compares the energy at the start and the end of a minute, averaged over a second, relative to the energy of the
/// swing (from level to hanging).
void expectEnergyKept(int count, double tolerance) {
  test::Rig rig(pendulum(count));
  std::vector<world::Slot> links;
  double swing = 0;
  for (int i = 0; i < count; ++i) {
    links.push_back(static_cast<world::Slot>(i));
    swing += kG * (0.5 + i);
  }
  const double start = energyOf(rig, links);
  double first = 0;
  double last = 0;
  double largest = 0;
  double gap = 0;
  for (int i = 0; i < 60000; ++i) {
    rig.step();
    const double energy = energyOf(rig, links) - start;
    if (i < 1000) first += energy / 1000;
    if (i >= 59000) last += energy / 1000;
    largest = std::max(largest, std::abs(energy));
    gap = std::max(gap, (rig.state.links[0].X_WorldLink * Vector3(-0.5, 0, 0)).norm());
    for (std::size_t k = 1; k < links.size(); ++k) {
      gap = std::max(gap, (rig.state.links[k - 1].X_WorldLink * Vector3(0.5, 0, 0) -
                           rig.state.links[k].X_WorldLink * Vector3(-0.5, 0, 0))
                              .norm());
    }
  }
  const double drift = std::abs(last - first) / swing;
  note("drift", drift);
  note("largest", largest / swing);
  note("gap_m", gap);
  EXPECT_LT(drift, tolerance);
  EXPECT_LT(gap, 1e-4);
}

TEST(AnalyticJoints, KeepThePendulumsEnergyForAMinute) { expectEnergyKept(1, 1e-3); }

TEST(AnalyticJoints, KeepTheDoublePendulumsEnergyForAMinute) { expectEnergyKept(2, 1e-3); }

TEST(AnalyticJoints, SwingWithThePendulumsPeriod) {
  test::Rig rig(pendulum(1));
  // from level: T = 4 K(sin(90 deg / 2)) sqrt(I / (m g l)), K = 1.8540746773
  const double period = 4 * 1.8540746773013719 * std::sqrt((1.0 / 3) / (kG * 0.5));
  int turns = 0;
  int last = 0;
  for (int i = 1; turns < 20; ++i) {
    const double before = rig.joint(0).velocity;
    rig.step();
    if (before < 0 && rig.joint(0).velocity >= 0) {
      ++turns;
      last = i;
    }
  }
  note("period", last * 1e-3 / 20 / period - 1);
  EXPECT_NEAR(last * 1e-3 / 20, period, 1e-3 * period);
}

TEST(AnalyticJoints, PrecessAsAGyroscopeDoes) {
  // a fast top with its axis level, held at one end: it goes round at m g l / (I w)
  description::Link top = test::makeLink("top", {0.5, 0, 0}, 1, {0.5, 0.3, 0.3});
  description::Model model = test::makeModel("model", {top});
  model.joints.push_back(test::makeJoint("joint", JointType::kBall, "world", "top", Pose(), test::at(-0.5, 0, 0)));
  description::World world;
  world.gravity = {0, 0, -kG};
  world.models = {model};
  test::Rig rig(std::move(world));
  const double spin = 100;
  const double rate = kG * 0.5 / (0.5 * spin);
  // a regular precession from the start: spin about its axis, and the turn of that about z
  rig.engine.setLinkVelocity(0, {0, 0.5 * rate, 0}, {spin, 0, rate});
  rig.step(5000);
  const Vector3 axis = rig.link("model::top").X_WorldLink.position.normalized();
  note("angle", std::atan2(axis.y(), axis.x()) / (5 * rate) - 1);
  EXPECT_NEAR(std::atan2(axis.y(), axis.x()), 5 * rate, 0.01 * 5 * rate);
  EXPECT_NEAR(axis.z(), 0, 0.02);
}

TEST(AnalyticJoints, TiltAFrameWhoseBladesTurnFast) {
  // two blades turn by 0.65 rad a step, against each other, so that their spin cancels: what is left is the inertia
  description::Model model = test::makeModel("model", {test::makeLink("frame", {0, 0, 0}, 1.5, {0.035, 0.07, 0.1})});
  for (const double x : {-0.2, 0.2}) {
    const std::string name = x < 0 ? "left" : "right";
    model.links.push_back(test::makeLink(name, {x, 0, 0}, 0.005, {1e-6, 4e-5, 4e-5}));
    model.joints.push_back(
        test::makeJoint("hinge_" + name, JointType::kRevolute, "frame", name, test::at(x, 0, 0), Pose()));
  }
  description::World world;
  world.gravity.setZero();
  world.models = {model};
  test::Rig rig(std::move(world));
  rig.engine.setJointVelocityTarget(0, 650);
  rig.engine.setJointVelocityTarget(1, -650);
  rig.step(100);
  constexpr int kSteps = 200;
  for (int i = 0; i < kSteps; ++i) {
    rig.engine.addLinkWrench(0, Vector3::Zero(), {0.02, 0, 0});
    rig.step();
  }
  const double expected = 0.02 * kSteps * 1e-3 / (0.035 + 2 * 4e-5 / 2);
  note("turn", rig.link("model::frame").w_WorldLink.x() / expected - 1);
  EXPECT_NEAR(rig.link("model::frame").w_WorldLink.x(), expected, 0.05 * expected);
}

TEST(AnalyticJoints, HoldABladeOnAShaftThatTurnsFast) {
  // 0.3 rad a step: straight on for a step the blade would be 2 cm outside of its circle
  description::Model model = test::makeModel("model", {test::makeLink("shaft", {0, 0, 0}, 1, {0.01, 0.01, 0.01}),
                                                       test::makeLink("blade", {0.5, 0, 0}, 0.1, {1e-4, 1e-3, 1e-3})});
  model.joints = {test::makeJoint("hinge", JointType::kRevolute, "world", "shaft", Pose(), Pose()),
                  test::makeJoint("hold", JointType::kFixed, "shaft", "blade", test::at(0.5, 0, 0), Pose())};
  description::World world;
  world.gravity.setZero();
  world.models = {model};
  test::Rig rig(std::move(world));
  rig.engine.setJointVelocityTarget(0, 300);
  rig.step(500);
  rig.engine.releaseJoint(0);
  double gap = 0;
  for (int i = 0; i < 1000; ++i) {
    rig.step();
    gap = std::max(gap, std::abs(rig.link("model::blade").X_WorldLink.position.norm() - 0.5));
  }
  note("gap", gap);
  EXPECT_LT(gap, 1e-4);
  EXPECT_NEAR(rig.link("model::shaft").w_WorldLink.z(), 300, 0.3);
}

TEST(AnalyticJoints, SwingOnASpringWithADamper) {
  description::Model model = test::makeModel("model", {test::makeLink("mass", {0, 0, 0}, 2, {1, 1, 1})});
  model.joints.push_back(
      test::makeJoint("spring", JointType::kPrismatic, "world", "mass", Pose(), Pose(), Vector3::UnitX()));
  description::JointAxis& axis = model.joints[0].axes[0];
  axis.springStiffness = 200;
  axis.damping = 2;
  axis.springReference = 0.1;
  description::World world;
  world.gravity.setZero();
  world.models = {model};
  test::Rig rig(std::move(world));
  // x(t) = r (1 - e^(-d t) (cos(w t) + d / w sin(w t))), d = c / 2 m, w = sqrt(k / m - d^2)
  const double d = 2.0 / 4;
  const double w = std::sqrt(100 - d * d);
  double largest = 0;
  for (int i = 1; i <= 5000; ++i) {
    rig.step();
    const double t = i * 1e-3;
    const double expected = 0.1 * (1 - std::exp(-d * t) * (std::cos(w * t) + d / w * std::sin(w * t)));
    largest = std::max(largest, std::abs(rig.joint(0).position - expected));
  }
  // a step that is implicit, as DART's, takes some of the swing
  note("largest_m", largest);
  EXPECT_LT(largest, 4e-3);
}

}  // namespace
}  // namespace pongsim::physics
