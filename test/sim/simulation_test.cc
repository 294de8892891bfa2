#include "pongsim/simulation.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "support/fortress_worlds.hh"

namespace pongsim {
namespace {

std::string pongWorld() { return (test::projectFolder() / "worlds/pong_world.sdf").string(); }

std::unique_ptr<Simulation> load(const std::string& file, const SimulationOptions& options = {}) {
  Diagnostics diagnostics;
  std::unique_ptr<Simulation> simulation = Simulation::fromFile(file, options, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  return simulation;
}

TEST(Simulation, RunsAThousandStepsWithoutSystems) {
  const auto simulation = load(pongWorld(), {.loadSystems = false});
  ASSERT_NE(simulation, nullptr);
  simulation->step(1000);
  EXPECT_EQ(simulation->time(), std::chrono::seconds(1));
  EXPECT_EQ(simulation->iterations(), 1000U);
  const Pose chassis = simulation->world().model("pong_bot")->link("chassis")->pose();
  EXPECT_NEAR(chassis.position.x(), 0.5, 0.01);
  EXPECT_NEAR(chassis.position.z(), 0.4, 0.005);
}

TEST(Simulation, EndsWithTheSameBitsEachTime) {
  const auto first = load(pongWorld()), second = load(pongWorld());
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->stateHash(), second->stateHash());
  first->step(1000);
  EXPECT_NE(first->stateHash(), second->stateHash());
  for (int i = 0; i < 1000; ++i) second->step();
  EXPECT_EQ(first->stateHash(), second->stateHash());
}

TEST(Simulation, DrivesByKeysWithinOneProcess) {
  const auto simulation = load(pongWorld());
  ASSERT_NE(simulation, nullptr);
  Publisher keys = simulation->transport().node().advertise("/keyboard/keypress", "ignition.msgs.Int32");
  const MessagePointer up = newMessage("ignition.msgs.Int32");
  ASSERT_FALSE(parseMessage("data: 16777235", *up).has_value());
  keys.publish(*up);
  simulation->step(2000);
  const Model robot = simulation->world().model("pong_bot").value();
  EXPECT_NEAR(robot.pose().position.x(), 1, 0.05);
  EXPECT_NEAR(robot.joint("left_wheel_joint")->velocity(), 0.5 / 0.4, 1e-3);
}

TEST(Simulation, ChangesNothingWhilePaused) {
  const auto simulation = load(pongWorld());
  ASSERT_NE(simulation, nullptr);
  simulation->step(10);
  const std::uint64_t before = simulation->stateHash();
  for (int i = 0; i < 10; ++i) simulation->stepPaused();
  EXPECT_EQ(simulation->stateHash(), before);
}

TEST(Simulation, GivesTheFilesMistakes) {
  Diagnostics diagnostics;
  EXPECT_EQ(Simulation::fromFile("no/such/world.sdf", {}, diagnostics), nullptr);
  EXPECT_TRUE(diagnostics.hasErrors());
}

TEST(Simulation, PutsAModelWithoutAWorldIntoOne) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(
      R"(<sdf version="1.9"><model name="ball"><pose>0 0 1 0 0 0</pose><link name="l"><collision name="c"><geometry>
         <sphere><radius>0.5</radius></sphere></geometry></collision></link></model></sdf>)",
      "ball.sdf", {}, diagnostics);
  ASSERT_NE(simulation, nullptr);
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_EQ(simulation->world().name(), "default");
  simulation->step(2000);
  EXPECT_NEAR(simulation->world().model("ball")->pose().position.z(), 0.5, 0.01);
}

TEST(Simulation, LeavesAModelThatIsTheGroundAlone) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(
      R"(<sdf version="1.9"><model name="ground_plane"><static>1</static><link name="l"/></model></sdf>)", "g.sdf", {},
      diagnostics);
  ASSERT_NE(simulation, nullptr);
  EXPECT_EQ(simulation->world().models().size(), 1U);
}

TEST(Simulation, WarnsOfFurtherWorlds) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(R"(<sdf version="1.9"><world name="one"/><world name="two"/></sdf>)",
                                               "two.sdf", {}, diagnostics);
  ASSERT_NE(simulation, nullptr);
  EXPECT_EQ(simulation->world().name(), "one");
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message, "world 'two' is left out: pongsim runs the first world of a file, 'one'");
}

TEST(Simulation, TakesItsSolverFromTheWorld) {
  // a box that slides to a halt, which iterations and the direct method see differently in the last bits
  const auto hashWith = [](const std::string& solver) {
    Diagnostics diagnostics;
    const auto simulation = Simulation::fromText(
        "<sdf version='1.9'><world name='w'><physics type='dart'><dart><solver><solver_type>" + solver +
            "</solver_type></solver></dart></physics><model name='ground'><static>true</static><link "
            "name='l'><collision "
            "name='c'><geometry><plane/></geometry></collision></link></model><model name='m'><pose>0 0 0.6 0.1 0.2 0"
            "</pose><link name='l'><inertial><mass>1</mass></inertial><collision name='c'><geometry><box><size>1 1 1"
            "</size></box></geometry></collision></link></model></world></sdf>",
        "world.sdf", {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) {
      EXPECT_EQ(diagnostic.message, "there is no solver '" + solver + "': 'dantzig' is taken");
    }
    simulation->step(500);
    return simulation->stateHash();
  };
  EXPECT_NE(hashWith("pgs"), hashWith("dantzig"));
  EXPECT_EQ(hashWith("dantsig"), hashWith("dantzig"));
}

/// A `<plugin>` of the scene broadcaster, which publishes poses so often a second.
Element sceneBroadcaster(const std::string& poseHertz) {
  Element plugin, hertz;
  plugin.name = "plugin";
  plugin.attributes = {{"filename", "ignition-gazebo-scene-broadcaster-system", {}},
                       {"name", "ignition::gazebo::systems::SceneBroadcaster", {}}};
  hertz.name = "dynamic_pose_hertz";
  hertz.text = poseHertz;
  plugin.children.push_back(hertz);
  return plugin;
}

constexpr const char* kFallingBox =
    "<sdf version='1.9'><world name='w'>"
    "<plugin filename='ignition-gazebo-physics-system' name='ignition::gazebo::systems::Physics'/>@"
    "<model name='m'><link name='l'/></model></world></sdf>";

/// @return How many poses a simulated second has, in a world with more plugins and with systems that are given.
int posesOfASecond(const std::string& plugins, const std::vector<Element>& systems) {
  std::string text = kFallingBox;
  text.replace(text.find('@'), 1, plugins);
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(text, "w.sdf", {.systems = systems}, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  int poses = 0;
  const Subscription subscription = simulation->transport().node().subscribe(
      "/world/w/dynamic_pose/info", "ignition.msgs.Pose_V", [&poses](const Message&) { ++poses; });
  simulation->step(1000);
  return poses;
}

TEST(Simulation, HasTheSystemsThatItIsGivenBesideThoseOfTheWorld) {
  EXPECT_EQ(posesOfASecond("", {}), 0);
  EXPECT_GT(posesOfASecond("", {sceneBroadcaster("10")}), 5);
}

TEST(Simulation, HasASystemOnceOfWhichTheWorldAndItsUserSpeakAndTheUserIsRight) {
  const std::string inFile =
      "<plugin filename='gz-sim-scene-broadcaster-system' name='gz::sim::systems::SceneBroadcaster'>"
      "<dynamic_pose_hertz>50</dynamic_pose_hertz></plugin>";
  const int often = posesOfASecond(inFile, {}), seldom = posesOfASecond(inFile, {sceneBroadcaster("10")});
  EXPECT_GT(often, 40);
  EXPECT_LT(seldom, 15);
  EXPECT_GT(seldom, 5);
}

TEST(Simulation, TakesItsStepFromTheWorld) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(
      R"(<sdf version="1.9"><world name="w"><physics name="p" type="ode"><max_step_size>0.004</max_step_size>
         <real_time_factor>2</real_time_factor></physics></world></sdf>)",
      "w.sdf", {}, diagnostics);
  ASSERT_NE(simulation, nullptr);
  EXPECT_EQ(simulation->stepSize(), std::chrono::milliseconds(4));
  EXPECT_EQ(simulation->realTimeFactor(), 2);
  simulation->step(3);
  EXPECT_EQ(simulation->time(), std::chrono::milliseconds(12));
}

}  // namespace
}  // namespace pongsim
