#include "physics/solving/direct_solver.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using description::JointType;
using test::Rig;

/// A body on four legs of three links each, in its standing height, with damped joints, some at their limits.
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

/// The result of very many iterations.
Settings manyIterations() {
  Settings settings;
  settings.solver = Solver::kGaussSeidel;
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

constexpr JointType kTypes[] = {JointType::kRevolute, JointType::kContinuous, JointType::kPrismatic, JointType::kBall,
                                JointType::kFixed,    JointType::kUniversal,  JointType::kRevolute2, JointType::kScrew};

/// A different rotation for each number.
Quaternion turn(int number) { return fromRollPitchYaw(0.4 + number, 0.3 - 0.7 * number, 1.1 * number - 2); }

/// Four links in a row, connected by a hinge, a joint of that type and a hinge, each in its own frame.
description::Model rowWith(JointType type) {
  std::vector<description::Link> links;
  std::vector<description::Joint> joints;
  for (int i = 0; i < 4; ++i) {
    const std::string name = "link" + std::to_string(i);
    links.push_back(test::makeLink(name, {0.2, -0.1, 0.3}, 1 + 0.5 * i, {0.03, 0.04 + 0.01 * i, 0.05}));
    links.back().X_ModelLink.rotation = turn(7);
    if (i == 0) continue;
    const Pose X_ParentJoint({0.2, 0.05, -0.1 * i}, turn(i)), X_ChildJoint({-0.1, 0.2, 0.05 * i}, turn(i + 3));
    const Vector3 axis = Vector3(1, -2, 0.5 * i).normalized();
    const std::size_t child = links.size() - 1;
    links[child].X_ModelLink = links[child - 1].X_ModelLink * X_ParentJoint * X_ChildJoint.inverse();
    joints.push_back(test::makeJoint(name, i == 2 ? type : JointType::kRevolute, "link" + std::to_string(i - 1), name,
                                     X_ParentJoint, X_ChildJoint, axis));
    if (i != 2) continue;
    joints.back().threadPitch = 0.3;
    if (type == JointType::kUniversal || type == JointType::kRevolute2) {
      joints.back().axes.emplace_back().xyz = axis.cross(Vector3(0.3, 1, 2)).normalized();
    }
  }
  description::Model model = test::makeModel("row", links);
  model.joints = joints;
  return model;
}

/// A gear train with an arm on one of the gears, rotated as a whole.
description::Model gearsWithArm() {
  description::Model model = test::makeGearTrain(3);
  model.X_ParentModel = {{0.5, 0.2, 1}, turn(4)};
  model.links.push_back(test::makeLink("arm", {0, 2, 0}, 1, {0.1, 0.1, 0.1}));
  model.joints.push_back(
      test::makeJoint("hinge_arm", JointType::kRevolute, "b", "arm", test::at(0, 0.5, 0), test::at(0, -0.5, 0)));
  return model;
}

/// A free-floating model whose links have arbitrary velocities.
struct Floating : Rig {
  explicit Floating(const description::Model& model, const Settings& settings = Settings())
      : Rig(worldOf(model), settings) {
    for (world::Slot i = 0; i < state.links.size(); ++i) {
      const double number = static_cast<double>(i);
      engine.setLinkVelocity(i, {0.5 - 0.3 * number, 0.2 * number, 0.4}, {0.8 - number, 0.6, 0.5 * number - 0.4});
    }
  }

  static description::World worldOf(const description::Model& model) {
    description::World world;
    world.gravity = Vector3::Zero();
    world.models = {model};
    return world;
  }

  Vector3 momentum() const {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < state.links.size(); ++i) {
      sum += description.models[0].links[i].inertial.mass * state.links[i].v_WorldLink;
    }
    return sum;
  }
  /// About the world's origin.
  Vector3 angularMomentum() const {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < state.links.size(); ++i) {
      const description::Inertial& inertial = description.models[0].links[i].inertial;
      const world::LinkState& link = state.links[i];
      const Matrix3 R = link.X_WorldLink.rotation.toRotationMatrix();
      sum += inertial.mass * link.X_WorldLink.position.cross(link.v_WorldLink) +
             R * inertial.moments * R.transpose() * link.w_WorldLink;
    }
    return sum;
  }
};

TEST(DirectSolver, FindsInTreesWithEachKindOfJointWhatIterationsComeTo) {
  std::vector<description::Model> models = {gearsWithArm()};
  for (const JointType type : kTypes) models.push_back(rowWith(type));
  for (const description::Model& model : models) {
    SCOPED_TRACE(description::name(model.joints[1].type));
    Floating direct(model), iterated(model, manyIterations());
    direct.step();
    iterated.step();
    expectTheSameVelocities(direct, iterated, 1e-4);
  }
}

/// The wrenches of all joints in a step, the first of which tells that they are measured.
std::vector<Engine::Reaction> reactions(Rig& rig) {
  const auto joints = static_cast<world::Slot>(rig.state.joints.size());
  for (world::Slot joint = 0; joint < joints; ++joint) rig.engine.jointReaction(joint);
  rig.step();
  std::vector<Engine::Reaction> result;
  for (world::Slot joint = 0; joint < joints; ++joint) result.push_back(rig.engine.jointReaction(joint));
  return result;
}

void expectTheSameReactions(Rig& rig, Rig& iterated) {
  const std::vector<Engine::Reaction> found = reactions(rig), expected = reactions(iterated);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LT((found[i].force - expected[i].force).norm(), 1e-2 + 1e-3 * expected[i].force.norm()) << i;
    EXPECT_LT((found[i].torque - expected[i].torque).norm(), 1e-2 + 1e-3 * expected[i].torque.norm()) << i;
  }
}

// joints that hold links measure no rows, but what moves the links
TEST(DirectSolver, MeasuresInTreesWhatIterationsComeTo) {
  {
    // at rest, with limits and contacts
    Rig direct(walker()), iterated(walker(), manyIterations());
    expectTheSameReactions(direct, iterated);
  }
  for (const JointType type : kTypes) {
    SCOPED_TRACE(description::name(type));
    description::Model model = rowWith(type);
    Floating direct(model), iterated(model, manyIterations());
    expectTheSameReactions(direct, iterated);
    // the first link of the file is the last child, so that all joints are reversed
    std::ranges::reverse(model.links);
    Floating reversed(model), iteratedReversed(model, manyIterations());
    expectTheSameReactions(reversed, iteratedReversed);
  }
}

TEST(DirectSolver, KeepsTheMomentumOfTreesWithEachKindOfJoint) {
  std::vector<description::Model> models = {gearsWithArm()};
  for (const JointType type : kTypes) models.push_back(rowWith(type));
  for (const description::Model& model : models) {
    SCOPED_TRACE(description::name(model.joints[1].type));
    Floating rig(model);
    rig.step();
    const Vector3 before = rig.momentum(), angularBefore = rig.angularMomentum();
    rig.step(500);
    EXPECT_LT((rig.momentum() - before).norm(), 1e-6 * before.norm());
    EXPECT_LT((rig.angularMomentum() - angularBefore).norm(), 0.01 * angularBefore.norm());
  }
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
