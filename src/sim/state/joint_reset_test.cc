// Joint positions that are set between steps.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "pongsim/simulation.hh"

namespace pongsim {
namespace {

std::unique_ptr<Simulation> resettable(const std::string& joints) {
  Diagnostics diagnostics;
  auto simulation = Simulation::fromText(
      R"(<sdf version="1.9"><world name="w"><gravity>0 0 0</gravity><model name="m">
      <link name="base"><inertial><mass>2</mass></inertial></link>
      <link name="arm"><pose>1 0 0 0 0 0</pose><inertial><mass>2</mass></inertial></link>
      <link name="hand"><pose>2 0 0 0 0 0</pose><inertial><mass>2</mass></inertial></link>
      <joint name="root" type="fixed"><parent>world</parent><child>base</child></joint>
      <joint name="wrist" type="ball"><parent>arm</parent><child>hand</child></joint>)" +
          joints + "</model></world></sdf>",
      "world.sdf", {.loadSystems = false}, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  return simulation;
}

// the joint's axis is z, through the world's origin
constexpr const char* kHinge = R"(<joint name="j" type="revolute"><parent>base</parent><child>arm</child>
  <pose>-1 0 0 0 0 0</pose><axis><xyz>0 0 1</xyz></axis></joint>)";

TEST(JointReset, TurnsAllThatHangsOnTheChild) {
  const auto simulation = resettable(kHinge);
  const Model model = simulation->world().model("m").value();
  Joint joint = model.joint("j").value();
  EXPECT_TRUE(joint.resetPosition(M_PI / 2 + 2 * M_PI));
  EXPECT_EQ(joint.position(), M_PI / 2 + 2 * M_PI);
  EXPECT_LT((model.link("arm")->pose().position - Vector3(0, 1, 0)).norm(), 1e-12);
  EXPECT_LT((model.link("hand")->pose().position - Vector3(0, 2, 0)).norm(), 1e-12);
  EXPECT_EQ(model.link("base")->pose().position, Vector3::Zero());
  EXPECT_TRUE(joint.resetVelocity(3));
  EXPECT_EQ(joint.velocity(), 3);
  EXPECT_LT((model.link("hand")->linearVelocity() - Vector3(-6, 0, 0)).norm(), 1e-12);
  simulation->step();
  EXPECT_NEAR(joint.position(), M_PI / 2 + 2 * M_PI + 0.003, 1e-4);
  EXPECT_NEAR(joint.velocity(), 3, 1e-2);
}

TEST(JointReset, SlidesAndScrews) {
  for (const auto& [type, turn] : {std::pair{"prismatic", 0.0}, std::pair{"screw", 0.5}}) {
    const auto simulation = resettable(std::string("<joint name='j' type='") + type +
                                       "'><parent>base</parent><child>arm</child><axis><xyz>1 0 0</xyz></axis>"
                                       "<thread_pitch>6.283185307179586</thread_pitch></joint>");
    const Model model = simulation->world().model("m").value();
    Joint joint = model.joint("j").value();
    EXPECT_TRUE(joint.resetPosition(0.5));
    EXPECT_TRUE(joint.resetVelocity(2));
    EXPECT_NEAR(model.link("hand")->pose().position.x(), 2.5, 1e-9);
    EXPECT_NEAR(model.link("hand")->linearVelocity().x(), 2, 1e-9);
    EXPECT_NEAR(2 * std::asin(model.link("arm")->pose().rotation.x()), turn, 1e-9);
    simulation->step();
    EXPECT_NEAR(joint.position(), 0.502, 1e-5);
    EXPECT_NEAR(joint.velocity(), 2, 1e-3);
  }
}

TEST(JointReset, TurnsEachAxisOfACross) {
  const auto simulation = resettable(R"(<joint name="j" type="universal"><parent>base</parent><child>arm</child>
    <axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint>)");
  Joint joint = simulation->world().model("m")->joint("j").value();
  EXPECT_TRUE(joint.resetPosition(0.4, 0));
  EXPECT_TRUE(joint.resetPosition(-0.3, 1));
  EXPECT_TRUE(joint.resetVelocity(0.7, 1));
  simulation->step();
  EXPECT_NEAR(joint.position(0), 0.4, 1e-4);
  EXPECT_NEAR(joint.position(1), -0.2993, 1e-4);
  EXPECT_NEAR(joint.velocity(1), 0.7, 1e-2);
}

TEST(JointReset, IsRefusedWhereItCanNotBe) {
  const auto simulation = resettable(std::string(kHinge) + R"(<joint name="loop" type="ball"><parent>base</parent>
    <child>hand</child></joint>)");
  Joint joint = simulation->world().model("m")->joint("j").value();
  const std::uint64_t hash = simulation->stateHash();
  EXPECT_EQ(joint.resetPosition(1).error,
            "joint 'j' can't be reset: other joints also connect its child to its parent or the world");
  EXPECT_EQ(joint.resetVelocity(1, 1).error, "joint 'j' has no axis 1");
  const auto free = resettable(kHinge);
  Joint hinge = free->world().model("m")->joint("j").value();
  EXPECT_EQ(hinge.resetPosition(std::numeric_limits<double>::infinity()).error,
            "joint 'j' can't be reset to a value that is not finite");
  EXPECT_EQ(simulation->stateHash(), hash);
}

}  // namespace
}  // namespace pongsim
