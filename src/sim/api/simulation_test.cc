#include "pongsim/simulation.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/imu.pb.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/temp_folder.hh"

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
  EXPECT_EQ(diagnostics.all()[0].message, "world 'two' is left out: the first one is used, 'one'");
}

TEST(Simulation, IsTheWorldOfTheFileThatIsAskedFor) {
  Diagnostics diagnostics;
  const auto load = [&diagnostics](const std::string& world) {
    return Simulation::fromText(R"(<sdf version="1.9"><world name="one"/><world name="two"/></sdf>)", "two.sdf",
                                {.world = world}, diagnostics);
  };
  const auto two = load("two");
  ASSERT_NE(two, nullptr);
  EXPECT_EQ(two->world().name(), "two");
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_EQ(load("three"), nullptr);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(format(diagnostics.all()[0]),
            "two.sdf:1:20: error: there is no world 'three' in this file\n  hint: it has 'one', 'two'");
}

/// Two worlds, each with an IMU that has noise.
class AllWorlds : public testing::Test {
 protected:
  static std::string world(const std::string& name) {
    return "<world name='" + name +
           "'><plugin filename='ignition-gazebo-physics-system' name='ignition::gazebo::systems::Physics'/>"
           "<plugin filename='ignition-gazebo-imu-system' name='ignition::gazebo::systems::Imu'/>"
           "<model name='m'><pose>0 0 10 0 0 0</pose><link name='l'><sensor name='s' "
           "type='imu'><always_on>1</always_on>"
           "<topic>imu_" +
           name +
           "</topic><imu><linear_acceleration><x><noise type='gaussian'><stddev>1</stddev></noise></x>"
           "</linear_acceleration></imu></sensor></link></model></world>";
  }
  std::filesystem::path file() const {
    return folder_.write("worlds.sdf", "<sdf version='1.9'>" + world("a") + world("b") + "</sdf>");
  }
  /// @return The IMU's measurement after one step.
  static double reading(Simulation& simulation) {
    double x = 0;
    const Subscription subscription = simulation.transport().node().subscribe<ignition::msgs::IMU>(
        "/imu_" + std::string(simulation.world().name()),
        [&x](const ignition::msgs::IMU& message) { x = message.linear_acceleration().x(); });
    simulation.step(1);
    simulation.transport().dispatch();
    EXPECT_NE(x, 0);
    return x;
  }

  const test::TempFolder folder_;
};

TEST_F(AllWorlds, HaveAShareInTheTransportAndRandomNumbersOfTheirOwn) {
  Transport transport({.network = false});
  Diagnostics diagnostics;
  const auto all = Simulation::allFromFile(file(), {.seed = 3, .transport = &transport}, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NE(&all[0]->transport(), &all[1]->transport());
  const double ofA = reading(*all[0]), ofB = reading(*all[1]);
  EXPECT_NE(ofA, ofB);
  // the second world's noise does not depend on the first world, at the start or after a reset
  const auto alone = load(file().string(), {.seed = 3, .world = "b"});
  EXPECT_EQ(reading(*alone), ofB);
  all[1]->reset(diagnostics);
  EXPECT_EQ(reading(*all[1]), ofB);
}

TEST_F(AllWorlds, DoNotTakeEachOthersState) {
  Diagnostics diagnostics;
  const auto all = Simulation::allFromFile(file(), {}, diagnostics);
  ASSERT_EQ(all.size(), 2U);
  all[0]->step(10);
  all[1]->step(20);
  const std::vector<std::byte> state = all[1]->saveState();
  EXPECT_FALSE(all[0]->restoreState(state));
  EXPECT_EQ(all[0]->iterations(), 10U);
  all[1]->step(10);
  const std::uint64_t hash = all[1]->stateHash();
  EXPECT_TRUE(all[1]->restoreState(state));
  all[1]->step(10);
  EXPECT_EQ(all[1]->stateHash(), hash);
}

TEST(Simulation, TakesItsSolverFromTheWorld) {
  // A box slides to rest; the iterative and the direct solver differ in the last bits.
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
      EXPECT_EQ(diagnostic.message, "there is no solver '" + solver + "': 'dantzig' is used");
    }
    simulation->step(500);
    return simulation->stateHash();
  };
  EXPECT_NE(hashWith("pgs"), hashWith("dantzig"));
  EXPECT_EQ(hashWith("dantsig"), hashWith("dantzig"));
}

/// A `<plugin>` for the scene broadcaster with this rate of poses [Hz].
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

/// @return The number of pose messages per simulated second, with `<plugin>`s in the world and given systems.
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
