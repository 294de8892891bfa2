#include "physics/solving/direct_solver.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "physics/rig.hh"

namespace pongsim::physics {
namespace {

using description::JointType;
using test::Rig;

/// A body on four legs of three links each, as high as it stands, its joints damped, some at their limits.
description::World walker() {
  const Vector3 size(0.5, 0.3, 0.1), legSize(0.05, 0.05, 0.2);
  description::Link body = test::makeLink("body", {0, 0, 0.6501}, 5, test::boxMoments(5, size));
  std::vector<description::Link> links = {body};
  std::vector<description::Joint> joints;
  for (int leg = 0; leg < 4; ++leg) {
    const double x = leg < 2 ? 0.2 : -0.2, y = leg % 2 == 0 ? 0.1 : -0.1;
    std::string parent = "body";
    for (int i = 0; i < 3; ++i) {
      const std::string name = "leg" + std::to_string(leg) + std::to_string(i);
      links.push_back(test::makeLink(name, {x, y, 0.5001 - 0.2 * i}, 0.5, test::boxMoments(0.5, legSize)));
      joints.push_back(test::makeJoint(name, JointType::kRevolute, parent, name,
                                       i == 0 ? test::at(x, y, -0.05) : test::at(0, 0, -0.1), test::at(0, 0, 0.1),
                                       i == 0 ? Vector3::UnitX() : Vector3::UnitY()));
      joints.back().axes[0].damping = 0.05;
      joints.back().axes[0].lower = i == 1 ? 0 : -0.5;
      joints.back().axes[0].upper = 0.5;
      if (i == 2) {
        test::addCollision(links.back(), description::Sphere{0.05}, 0);
        links.back().collisions.back().X_LinkCollision.position = {0, 0, -0.05};
      }
      parent = name;
    }
  }
  description::Model model = test::makeModel("walker", links);
  model.joints = joints;
  description::World world;
  world.models = {test::makeGround(0), model};
  return world;
}

/// What iterations come to if there are very many of them.
Settings manyIterations() {
  Settings settings;
  settings.solver = Solver::kSequentialImpulse;
  settings.iterations = 200000;
  return settings;
}

void expectTheSameVelocities(const Rig& rig, const Rig& expected, double tolerance) {
  for (std::size_t i = 0; i < rig.state.links.size(); ++i) {
    EXPECT_LT((rig.state.links[i].v_WorldLink - expected.state.links[i].v_WorldLink).norm(), tolerance) << i;
    EXPECT_LT((rig.state.links[i].w_WorldLink - expected.state.links[i].w_WorldLink).norm(), tolerance) << i;
  }
}

TEST(DirectSolver, FindsInTreesWhatIterationsComeTo) {
  Rig direct(walker()), iterated(walker(), manyIterations());
  for (Rig* rig : {&direct, &iterated}) {
    rig->engine.setLinkVelocity(rig->entities.findLink("walker::body"), {0.1, 0.05, -0.3}, {0.3, 0.2, 0.1});
    rig->step();
  }
  expectTheSameVelocities(direct, iterated, 2e-4);
}

TEST(DirectSolver, FindsInTreesWithGearboxesWhatIterationsComeTo) {
  description::World world;
  world.models = {test::makeGearTrain(3)};
  // an arm on a gear, which makes it a tree
  world.models[0].links.push_back(test::makeLink("arm", {0, 2, 0}, 1, {0.1, 0.1, 0.1}));
  world.models[0].joints.push_back(
      test::makeJoint("hinge_arm", JointType::kRevolute, "b", "arm", test::at(0, 0.5, 0), test::at(0, -0.5, 0)));
  Rig direct(world), iterated(world, manyIterations());
  for (Rig* rig : {&direct, &iterated}) {
    rig->engine.addJointForce(0, 40, 0);
    rig->engine.addJointForce(3, 20, 0);
    rig->step();
  }
  EXPECT_GT(direct.joint(0).velocity, 0.01);
  EXPECT_NEAR(direct.joint(1).velocity, -3 * direct.joint(0).velocity, 1e-5);
  expectTheSameVelocities(direct, iterated, 1e-5);
}

/// Rods of 0.1 m on hinges, level at the start.
description::World hangingChain(int links) {
  description::World world;
  std::vector<description::Link> all;
  std::vector<description::Joint> joints;
  for (int i = 0; i < links; ++i) {
    const std::string name = "rod" + std::to_string(i);
    all.push_back(test::makeLink(name, {0.1 * i + 0.05, 0, 12}, 0.1, test::boxMoments(0.1, {0.1, 0.02, 0.02})));
    joints.push_back(test::makeJoint(name, JointType::kRevolute, i == 0 ? "world" : "rod" + std::to_string(i - 1), name,
                                     i == 0 ? test::at(0, 0, 12) : test::at(0.05, 0, 0), test::at(-0.05, 0, 0),
                                     Vector3::UnitY()));
  }
  world.models = {test::makeModel("chain", all)};
  world.models[0].joints = joints;
  return world;
}

// 500 equations: iterations leave gaps of millimetres
TEST(DirectSolver, HoldsALongChainTogether) {
  Rig rig(hangingChain(100));
  rig.step(500);
  double widest = 0;
  for (int i = 1; i < 100; ++i) {
    const Pose& before = rig.link("chain::rod" + std::to_string(i - 1)).X_WorldLink;
    const Pose& here = rig.link("chain::rod" + std::to_string(i)).X_WorldLink;
    widest = std::max(widest, (before * Vector3(0.05, 0, 0) - here * Vector3(-0.05, 0, 0)).norm());
  }
  EXPECT_LT(widest, 1e-5);
}

}  // namespace
}  // namespace pongsim::physics
