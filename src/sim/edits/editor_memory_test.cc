// An edit in which an allocation fails takes effect completely or not at all, and leaves arrays of equal lengths.
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "sdf/loader.hh"
#include "sim/api/access.hh"
#include "sim/edits/editor.hh"
#include "support/failing_allocations.hh"

namespace pongsim::sim {
namespace {

constexpr const char* kWorld = R"(<sdf version="1.9"><world name="w">
    <model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane/></geometry>
      </collision></link></model>
    <model name="ball"><pose>0 0 1 0 0 0</pose><link name="l"><collision name="c"><geometry><sphere><radius>0.1</radius>
      </sphere></geometry></collision></link></model>
    <model name="crate"><pose>3 0 0.5 0 0 0</pose><link name="l"><collision name="c"><geometry><box><size>1 1 1</size>
      </box></geometry></collision></link></model>
  </world></sdf>)";

/// Two links with a joint, a nested model, a sensor, a light, and friction in the frame of another link.
constexpr const char* kRobot = R"(<sdf version="1.9"><model name="robot"><pose>0 2 0.5 0 0 0</pose>
    <link name="base"><velocity_decay><linear>0.1</linear></velocity_decay>
      <collision name="c"><geometry><box><size>1 1 1</size></box></geometry><surface><friction><ode>
        <fdir1 ignition:expressed_in="arm" xmlns:ignition="x">1 0 0</fdir1></ode></friction></surface></collision>
      <visual name="v"><geometry><box><size>1 1 1</size></box></geometry></visual>
      <light name="lamp" type="point"/><sensor name="s" type="imu"/></link>
    <link name="arm"><pose>0 0 1 0 0 0</pose></link>
    <joint name="elbow" type="revolute"><parent>base</parent><child>arm</child><axis><xyz>0 1 0</xyz></axis></joint>
    <model name="tool"><pose>0 0 2 0 0 0</pose><link name="tip"/></model>
    <joint name="wrist" type="fixed"><parent>arm</parent><child>tool::tip</child></joint></model></sdf>)";

struct Running {
  sdf::Root root;
  Access access;
  const world::Entities& entities = access.entities;
  world::State& state = access.state;
  Editor editor{access};

  explicit Running(Diagnostics diagnostics = {})
      : root(sdf::loadText(kWorld, "world.sdf", diagnostics, {})), access(root.worlds.at(0)) {}

  void step(int count) {
    ASSERT_EQ(state.links.size(), entities.links().size());
    ASSERT_EQ(state.joints.size(), entities.joints().size());
    for (int i = 0; i < count; ++i) access.engine.step(state.stepSize, state);
  }
};

std::shared_ptr<const description::Model> robot() {
  Diagnostics diagnostics;
  sdf::Root root = sdf::loadText(kRobot, "robot.sdf", diagnostics, {});
  EXPECT_FALSE(diagnostics.hasErrors());
  return std::make_shared<const description::Model>(std::move(root.models.at(0)));
}

class EditorMemoryTest : public testing::Test {
 protected:
  /// Makes an edit in two worlds. In one of them the edit is first tried with its first, second, ... allocation
  /// failing, with steps in between; the states must be equal afterwards.
  /// @param prepare Applied to both worlds before.
  void expectAllOrNothing(
      const std::function<void(Running&)>& edit, const std::function<void(Running&)>& prepare = [](Running&) {}) {
    Running failing, untouched;
    for (Running* running : {&failing, &untouched}) {
      prepare(*running);
      running->step(5);
    }
    int failures = 0;
    while (true) {
      const std::size_t models = failing.entities.models().size();
      const std::size_t joints = failing.entities.joints().size();
      bool isDone = true;
      test::allocationsUntilFailure = failures + 1;
      try {
        edit(failing);
      } catch (const std::bad_alloc&) {
        isDone = false;
      }
      test::allocationsUntilFailure = 0;
      if (isDone) break;
      ++failures;
      EXPECT_EQ(failing.entities.models().size(), models);
      EXPECT_EQ(failing.entities.joints().size(), joints);
      for (Running* running : {&failing, &untouched}) running->step(1);
      ASSERT_EQ(world::stateHash(failing.state), world::stateHash(untouched.state)) << failures;
    }
    EXPECT_GE(failures, 3);
    edit(untouched);
    for (Running* running : {&failing, &untouched}) running->step(200);
    EXPECT_EQ(world::stateHash(failing.state), world::stateHash(untouched.state));
    EXPECT_EQ(failing.access.entities.nextId(), untouched.access.entities.nextId());
  }
};

TEST_F(EditorMemoryTest, InsertsAModelOrNothingOfIt) {
  const auto model = robot();
  expectAllOrNothing([&](Running& running) { running.editor.insert(model); });
}

TEST_F(EditorMemoryTest, RemovesModelsOrNone) {
  const auto model = robot();
  expectAllOrNothing(
      [](Running& running) {
        running.editor.remove({running.entities.findModel("ball"), running.entities.findModel("robot")});
      },
      [&](Running& running) { running.editor.insert(model); });
}

TEST_F(EditorMemoryTest, AttachesLinksOrLeavesNoJoint) {
  expectAllOrNothing([](Running& running) {
    running.editor.attach(running.entities.findLink("crate::l"), running.entities.findLink("ball::l"), "leash");
  });
}

TEST_F(EditorMemoryTest, DetachesLinksOrKeepsTheJoint) {
  const auto model = robot();
  expectAllOrNothing(
      [](Running& running) {
        running.editor.detach(running.entities.findJoint(running.entities.findModel("robot"), "wrist"));
      },
      [&](Running& running) { running.editor.insert(model); });
}

}  // namespace
}  // namespace pongsim::sim
