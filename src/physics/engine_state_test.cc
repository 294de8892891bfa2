// Saved and restored states of the engine: the next steps have the same bits.

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "physics/engine.hh"
#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using description::JointType;

description::Link linkOf(description::Geometry geometry, double mass = 1) {
  description::Link link = test::makeLink("link", {0, 0, 0}, mass, {0.02, 0.03, 0.04});
  test::addCollision(link, std::move(geometry));
  return link;
}

// shapes of all kinds falling on a ground, on a table made of parts, and on each other
description::World heap() {
  description::World world;
  description::Link table = linkOf(description::Box{{1, 1, 0.2}});
  test::addCollision(table, description::Box{{0.2, 0.2, 0.6}});
  table.collisions[0].X_LinkCollision.position.z() = 0.4;
  table.collisions[1].X_LinkCollision.position.x() = 0.3;
  description::Model fixed = test::makeModel("table", {table});
  fixed.isStatic = true;
  world.models = {test::makeGround(), fixed};
  description::Link dumbbell = linkOf(description::Sphere{0.1});
  test::addCollision(dumbbell, description::Sphere{0.1});
  dumbbell.collisions[1].X_LinkCollision.position.x() = 0.3;
  const std::vector<description::Link> kinds = {
      linkOf(description::Box{{0.3, 0.2, 0.1}}), linkOf(description::Cylinder{0.1, 0.2}),
      linkOf(description::Capsule{0.1, 0.2}), dumbbell, linkOf(description::Ellipsoid{{0.1, 0.15, 0.2}})};
  for (int i = 0; i < 15; ++i) {
    description::Model model = test::makeModel("m" + std::to_string(i), {kinds[static_cast<std::size_t>(i) % 5]});
    model.X_ParentModel = {{0.04 * i - 0.3, 0.03 * (i % 4), 0.8 + 0.3 * i}, fromRollPitchYaw(0.3 * i, 0.1, 0.2 * i)};
    world.models.push_back(model);
  }
  return world;
}

description::World drivenArm() {
  description::Link base = linkOf(description::Box{{0.4, 0.4, 0.1}}, 5);
  base.name = "base";
  description::Link arm = linkOf(description::Cylinder{0.05, 0.5});
  arm.name = "arm";
  arm.X_ModelLink.position.z() = 0.4;
  description::Model model = test::makeModel("arm", {base, arm});
  model.X_ParentModel.position.z() = 0.05;
  model.joints.push_back(test::makeJoint("hinge", JointType::kRevolute, "base", "arm", test::at(0, 0, 0.1),
                                         test::at(0, 0, -0.3), Vector3::UnitX()));
  model.joints[0].axes[0].damping = 0.1;
  model.joints[0].axes[0].upper = 1;
  description::World world;
  world.models = {test::makeGround(), model};
  return world;
}

description::World gearTrain() {
  description::World world;
  world.models = {test::makeGearTrain(1.5)};
  world.models[0].X_ParentModel.position.z() = 20;
  return world;
}

// a heap on a belt with a centre of rotation; one of the crates slips
description::World loadedBelt() {
  description::World world = heap();
  world.models.erase(world.models.begin());
  description::Link belt = linkOf(description::Box{{20, 20, 0.2}});
  belt.X_ModelLink.position.z() = -0.1;
  world.models.insert(world.models.begin(), test::makeModel("belt", {belt}));
  world.models[0].isStatic = true;
  return world;
}

// restores the state after some steps in another engine, which has run before
void expectSameFuture(const description::World& world, int before, void (*command)(Engine&)) {
  test::Rig original(world);
  command(original.engine);
  original.step(before);
  StateArchive taken;
  original.engine.transfer(taken);
  const std::vector<std::byte> bytes = taken.take();
  const world::State state = original.state;

  test::Rig other(world);
  other.step(37);
  StateArchive giving(bytes);
  other.engine.transfer(giving);
  EXPECT_TRUE(giving.rest().empty());
  other.state = state;
  // points that the next step drops need not have found their place
  original.step();
  other.step();
  StateArchive one, another;
  original.engine.transfer(one);
  other.engine.transfer(another);
  EXPECT_EQ(another.take().size(), one.take().size()) << "not all points of contact have found their place";
  for (int i = 0; i < 20; ++i) {
    original.step(50);
    other.step(50);
    ASSERT_EQ(world::stateHash(original.state), world::stateHash(other.state)) << (i + 1) * 50 << " steps later";
  }
}

class EngineState : public testing::TestWithParam<int> {};

TEST_P(EngineState, OfAHeapLeadsToTheSameBits) {
  expectSameFuture(heap(), GetParam(), [](Engine&) {});
}

TEST_P(EngineState, OfADrivenArmLeadsToTheSameBits) {
  expectSameFuture(drivenArm(), GetParam(), [](Engine& engine) { engine.setJointVelocityTarget(0, 0.7); });
}

TEST_P(EngineState, OfAGearTrainLeadsToTheSameBits) {
  expectSameFuture(gearTrain(), GetParam(), [](Engine& engine) { engine.setJointVelocityTarget(0, 3); });
}

TEST_P(EngineState, OfBodiesWithAddedMassLeadsToTheSameBits) {
  description::World world = heap();
  for (std::size_t i = 2; i < world.models.size(); i += 2) {
    world.models[i].links[0].inertial.addedMass = Eigen::Matrix<double, 6, 1>(1, 2, 3, 0.1, 0, 0.2).asDiagonal();
  }
  // the mass is restored, and with it the whole inertia
  expectSameFuture(world, GetParam(), [](Engine& engine) { engine.setMass(2, {2, 3}); });
}

TEST_P(EngineState, OfALoadedBeltLeadsToTheSameBits) {
  expectSameFuture(loadedBelt(), GetParam(), [](Engine& engine) {
    engine.setSurfaceMotion(0, 0, SurfaceMotion{.speed = 0.5, .center = Vector3(0, 2, 0)});
    engine.setSlip(3, 0, 0.01, 0.02);
  });
}

INSTANTIATE_TEST_SUITE_P(AfterSteps, EngineState, testing::Values(0, 1, 300, 700, 1500));

TEST(EngineStateOfAJoint, KeepsWhatItWasAskedToMeasureAndToDo) {
  test::Rig original(drivenArm());
  test::Rig other(drivenArm());
  original.engine.jointReaction(0);
  original.step(100);
  original.engine.addJointForce(0, 3);
  original.engine.addLinkWrench(2, {1, 2, 3}, {4, 5, 6});
  StateArchive taken;
  original.engine.transfer(taken);
  const std::vector<std::byte> bytes = taken.take();
  StateArchive giving(bytes);
  other.engine.transfer(giving);
  EXPECT_EQ(other.engine.jointReaction(0).force, original.engine.jointReaction(0).force);
  EXPECT_NE(other.engine.jointReaction(0).force, Vector3::Zero());
  other.state = original.state;
  original.step();
  other.step();
  EXPECT_EQ(world::stateHash(original.state), world::stateHash(other.state));
}

}  // namespace
}  // namespace pongsim::physics
