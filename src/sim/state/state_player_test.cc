#include "pongsim/state/state_player.hh"

#include <gtest/gtest.h>

#include <memory>

#include "pongsim/simulation.hh"

namespace pongsim {
namespace {

constexpr const char* kArm = R"(<sdf version="1.9"><world name="w">
  <physics name="p" type="ignored"><max_step_size>0.004</max_step_size></physics>
  <model name="m"><pose>0 0 1 0 0 0</pose>
    <link name="base"/><link name="arm"><pose>1 0 0 0 0 0</pose></link><link name="hand"/>
    <joint name="hinge" type="revolute"><parent>base</parent><child>arm</child><axis><xyz>0 0 1</xyz></axis></joint>
    <joint name="cross" type="universal"><parent>arm</parent><child>hand</child>
      <axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint>
  </model></world></sdf>)";

class StatePlayerTest : public testing::Test {
 protected:
  static std::unique_ptr<Simulation> load() {
    Diagnostics diagnostics;
    auto simulation = Simulation::fromText(kArm, "arm.sdf", {.loadSystems = false, .physics = false}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    return simulation;
  }

  Model model() { return simulation_->world().model("m").value(); }

  const std::unique_ptr<Simulation> simulation_ = load();
  StatePlayer player_{Scene(simulation_->world())};
};

TEST_F(StatePlayerTest, TellsTheTimeAndTheStep) {
  simulation_->step(3);
  EXPECT_EQ(player_.time(), std::chrono::milliseconds(12));
  EXPECT_EQ(player_.stepSize(), std::chrono::milliseconds(4));
}

TEST_F(StatePlayerTest, PutsALinkWhereItStaysAndLeavesTheOthers) {
  const Pose there{Vector3(3, 2, 1), Quaternion(Eigen::AngleAxisd(0.5, Vector3::UnitZ()))};
  player_.place(*model().link("arm"), there);
  simulation_->step(10);
  EXPECT_EQ(model().link("arm")->pose(), there);
  EXPECT_EQ(model().link("arm")->linearVelocity(), Vector3::Zero());
  EXPECT_EQ(model().link("base")->pose().position, Vector3(0, 0, 1));
}

TEST_F(StatePlayerTest, MovesTheModelWithItsCanonicalLink) {
  player_.place(*model().link("base"), {Vector3(5, 0, 0), Quaternion::Identity()});
  EXPECT_EQ(model().pose().position, Vector3(5, 0, 0));
}

TEST_F(StatePlayerTest, SetsWhatEachAxisOfAJointSaysAndMovesNothing) {
  const Pose before = model().link("arm")->pose();
  player_.setAxis(*model().joint("hinge"), 0, 0.5, 2);
  player_.setAxis(*model().joint("cross"), 0, 0.1, 0.2);
  player_.setAxis(*model().joint("cross"), 1, 0.3, 0.4);
  simulation_->step();
  EXPECT_EQ(model().joint("hinge")->position(), 0.5);
  EXPECT_EQ(model().joint("hinge")->velocity(), 2);
  EXPECT_EQ(model().joint("cross")->position(0), 0.1);
  EXPECT_EQ(model().joint("cross")->position(1), 0.3);
  EXPECT_EQ(model().joint("cross")->velocity(1), 0.4);
  EXPECT_EQ(model().link("arm")->pose(), before);
}

TEST_F(StatePlayerTest, RefusesWhatHasGone) {
  const Link arm = *model().link("arm");
  const Joint hinge = *model().joint("hinge");
  EXPECT_TRUE(simulation_->remove(model()));
  EXPECT_THROW(player_.place(arm, {}), Gone);
  EXPECT_THROW(player_.setAxis(hinge, 0, 1, 0), Gone);
}

}  // namespace
}  // namespace pongsim
