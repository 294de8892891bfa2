#include <gtest/gtest.h>

#include <string>

#include "pongsim/simulation.hh"

namespace pongsim {
namespace {

std::string world(const std::string& plugins) {
  return R"(<sdf version="1.9"><world name="w">)" + plugins + R"(
    <model name="ball"><pose>0 0 100 0 0 0</pose><link name="l"><inertial><mass>1</mass></inertial></link></model>
  </world></sdf>)";
}

double fallenAfterASecond(const std::string& text, const SimulationOptions& options, Diagnostics& diagnostics) {
  const auto simulation = Simulation::fromText(text, "world.sdf", options, diagnostics);
  if (simulation == nullptr) return -1;
  simulation->step(1000);
  return 100 - simulation->world().model("ball")->pose().position.z();
}

TEST(SystemSet, MovesBodiesInAWorldThatListsNoSystem) {
  Diagnostics diagnostics;
  EXPECT_NEAR(fallenAfterASecond(world(""), {}, diagnostics), 4.9, 0.01);
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(SystemSet, MovesBodiesWherePhysicsIsListed) {
  Diagnostics diagnostics;
  EXPECT_NEAR(fallenAfterASecond(world(R"(<plugin filename="libignition-gazebo-physics-system.so"
                                                  name="ignition::gazebo::systems::Physics"/>)"),
                                 {}, diagnostics),
              4.9, 0.01);
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(SystemSet, WarnsThatNothingMovesWherePhysicsIsMissing) {
  const std::string text = world(R"(<plugin filename="ignition-gazebo-scene-broadcaster-system"
                                            name="ignition::gazebo::systems::SceneBroadcaster"/>)");
  Diagnostics diagnostics;
  EXPECT_EQ(fallenAfterASecond(text, {}, diagnostics), 0);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message, "world 'w' lists systems, but not physics: nothing will move");
}

TEST(SystemSet, IgnoresPluginsWhenAskedTo) {
  Diagnostics diagnostics;
  EXPECT_NEAR(
      fallenAfterASecond(world(R"(<plugin filename="no-such" name="none"/>)"), {.loadSystems = false}, diagnostics),
      4.9, 0.01);
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(SystemSet, LeavesOutASystemThatCannotUseItsParameters) {
  Diagnostics diagnostics;
  EXPECT_NEAR(fallenAfterASecond(world(R"(<plugin filename="ignition-gazebo-physics-system" name=""/>
                                          <plugin filename="ignition-gazebo-diff-drive-system" name=""/>)"),
                                 {}, diagnostics),
              4.9, 0.01);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message, "diff-drive is left out: DiffDrive must stand in a <model>");
}

TEST(SystemSet, ReportsAllPluginsThatAreNotThereAtOnce) {
  Diagnostics diagnostics;
  EXPECT_EQ(fallenAfterASecond(world(R"(<plugin filename="no-such-thing" name="a"/>
                                        <plugin filename="nor-such-a-one" name="b"/>)"),
                               {}, diagnostics),
            -1);
  int errors = 0;
  for (const Diagnostic& diagnostic : diagnostics.all()) errors += diagnostic.severity == Severity::kError ? 1 : 0;
  EXPECT_EQ(errors, 2);
}

}  // namespace
}  // namespace pongsim
