// What is set aside with a level keeps its state bit for bit, including systems and sensors.

#include <gtest/gtest.h>
#include <ignition/msgs/imu.pb.h>
#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/scene.pb.h>
#include <ignition/msgs/uint32_v.pb.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "pongsim/simulation.hh"
#include "support/sim/forged_state.hh"
#include "support/sim/level_world.hh"

namespace pongsim {
namespace {

using test::place;

std::string boxModel(const std::string& name, const std::string& pose, const std::string& more = {}) {
  return "<model name='" + name + "'><pose>" + pose +
         "</pose><link name='l'><inertial><mass>1</mass><inertia><ixx>0.01" +
         "</ixx><iyy>0.02</iyy><izz>0.03</izz></inertia></inertial><collision name='c'><geometry><box><size>0.4 0.5 " +
         "0.2</size></box></geometry></collision>" + more + "</link></model>";
}

/// A model that is in no level.
const std::string kOther = boxModel("other", "0 40 0.8 0.5 0.2 0");

/// A driving robot, boxes that fall on the ground and on each other, and a pendulum, all in one level; a ground in
/// none; and a scout, which is the performer.
std::string playground() {
  const std::string noise =
      "<noise type='gaussian'><bias_mean>5</bias_mean><dynamic_bias_stddev>1e-9</dynamic_bias_stddev>"
      "<dynamic_bias_correlation_time>0.1</dynamic_bias_correlation_time></noise>";
  const std::string imu =
      "<sensor name='imu' type='imu'><topic>imu</topic><update_rate>100</update_rate><imu>"
      "<angular_velocity><x>" +
      noise + "</x></angular_velocity></imu></sensor>";
  const std::string wheel =
      "<inertial><mass>0.5</mass><inertia><ixx>0.002</ixx><iyy>0.002</iyy><izz>0.002</izz></inertia></"
      "inertial><collision "
      "name='c'><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>";
  const auto joint = [](const std::string& name) {
    return "<joint name='" + name + "_joint' type='revolute'><parent>body</parent><child>" + name +
           "</child><axis><xyz>0 1 0</xyz></axis></joint>";
  };
  const std::string rover =
      "<model name='rover'><pose>1 1 0.1 0 0 0</pose><link name='body'><inertial><mass>3</mass><inertia><ixx>0.05</ixx>"
      "<iyy>0.05</iyy><izz>0.05</izz></inertia></inertial><collision name='c'><pose>0.2 0 -0.05 0 0 0</pose><geometry>"
      "<sphere><radius>0.05</radius></sphere></geometry></collision></link><link name='left'><pose>0 0.2 0 0 0 "
      "0</pose>" +
      wheel + "</link><link name='right'><pose>0 -0.2 0 0 0 0</pose>" + wheel + "</link>" + joint("left") +
      joint("right") +
      "<plugin filename='ignition-gazebo-diff-drive-system' name='ignition::gazebo::systems::DiffDrive'>"
      "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint><wheel_separation>0.4</"
      "wheel_separation>"
      "<wheel_radius>0.1</wheel_radius></plugin></model>";
  const std::string pendulum =
      "<model name='pendulum'><pose>-2 0 2 0 0 0</pose><link name='l'><pose>0 0.5 0 0 0 "
      "0</pose><inertial><mass>1</mass>"
      "</inertial></link><joint name='j' type='revolute'><pose>0 -0.5 0 0 0 0</pose><parent>world</parent><child>l"
      "</child><axis><xyz>1 0 0</xyz></axis></joint></model>";
  const std::string level =
      "<level name='hall'><geometry><box><size>20 20 20</size></box></geometry><ref>rover</ref><ref>pendulum</ref>"
      "<ref>crate</ref><ref>lower</ref><ref>upper</ref></level>";
  return "<sdf version='1.9'><world name='w'><plugin filename='ignition-gazebo-physics-system' "
         "name='ignition::gazebo::systems::Physics'/><plugin filename='ignition-gazebo-imu-system' "
         "name='ignition::gazebo::systems::Imu'/><plugin filename='ignition-gazebo-scene-broadcaster-system' "
         "name='ignition::gazebo::systems::SceneBroadcaster'/>"
         "<model name='ground'><static>true</static><link name='l'><collision name='c'><geometry><plane/></geometry>"
         "</collision></link></model><model name='scout'><link name='l'><gravity>false</gravity></link></model>" +
         rover + boxModel("crate", "3 0 1 0.4 0.2 0.1", imu) + boxModel("lower", "0 3 0.3 0.2 0 0") +
         boxModel("upper", "0.05 3 0.7 0 0.3 0.4") + pendulum + kOther + "<plugin name='gz::sim' filename='dummy'>" +
         test::performerText("scout") + level + "</plugin></world></sdf>";
}

const char* const kMembers[] = {"rover", "crate", "lower", "upper", "pendulum"};
const Vector3 kFar(100, 0, 0);

std::unique_ptr<Simulation> play(SimulationOptions options = {.levels = true}) {
  auto simulation = test::simulate(playground(), options);
  const MessagePointer twist = newMessage("ignition.msgs.Twist");
  EXPECT_FALSE(parseMessage("linear: {x: 0.5}, angular: {z: 0.3}", *twist));
  Publisher publisher = simulation->transport().node().advertise("/model/rover/cmd_vel", "ignition.msgs.Twist");
  EXPECT_TRUE(publisher.hasSubscribers());
  publisher.publish(*twist);
  return simulation;
}

/// The complete state of everything in the level, for comparison bit for bit.
std::vector<double> bits(Simulation& simulation) {
  std::vector<double> values;
  for (const char* name : kMembers) {
    const Model model = simulation.world().model(name).value();
    for (const Link& link : model.links()) {
      const Pose pose = link.pose();
      for (const Vector3& vector : {pose.position, link.linearVelocity(), link.angularVelocity()}) {
        values.insert(values.end(), vector.begin(), vector.end());
      }
      values.insert(values.end(), pose.rotation.coeffs().begin(), pose.rotation.coeffs().end());
    }
    for (const Joint& joint : model.joints()) values.insert(values.end(), {joint.position(), joint.velocity()});
  }
  return values;
}

/// Moves the scout away, which unloads the level, steps, and moves it back.
void visit(Simulation& simulation, std::uint64_t steps) {
  place(simulation, "scout", kFar);
  simulation.step(steps);
  EXPECT_FALSE(simulation.world().model("crate"));
  place(simulation, "scout", {0, 0, 0});
}

class LevelBits : public testing::TestWithParam<int> {};

// Step numbers at which things fall, hit the ground, and are at rest except the rover and the pendulum.
TEST_P(LevelBits, AreThoseThatTheyWouldHaveBeen) {
  const auto moment = static_cast<std::uint64_t>(GetParam());
  const auto always = play({});
  const auto simulation = play();
  always->step(moment);
  simulation->step(moment);
  ASSERT_EQ(bits(*simulation), bits(*always));
  visit(*simulation, 500);
  for (int i = 0; i < 3; ++i) {
    always->step(i == 0 ? 1 : 200);
    simulation->step(i == 0 ? 1 : 200);
    ASSERT_EQ(bits(*simulation), bits(*always)) << "after " << i << " rounds";
  }
  visit(*simulation, 1);
  visit(*simulation, 300);
  always->step(100);
  simulation->step(100);
  ASSERT_EQ(bits(*simulation), bits(*always));
  EXPECT_EQ(simulation->iterations(), always->iterations() + 801);
}

INSTANTIATE_TEST_SUITE_P(Moments, LevelBits, testing::Values(1, 150, 250, 330, 450, 2000));

TEST(LevelSystems, RestWhileTheirModelIsSetAside) {
  const auto simulation = play();
  int odometry = 0;
  const Subscription subscription = simulation->transport().node().subscribe<ignition::msgs::Odometry>(
      "/model/rover/odometry", [&odometry](const auto&) { ++odometry; });
  simulation->step(3000);
  simulation->transport().dispatch();
  EXPECT_GE(odometry, 140);
  const int before = odometry;
  const double speed = simulation->world().model("rover")->links()[0].linearVelocity().norm();
  EXPECT_NEAR(speed, 0.5, 0.05);
  place(*simulation, "scout", kFar);
  simulation->step(1000);
  // messages to systems that are set aside are lost
  const MessagePointer halt = newMessage("ignition.msgs.Twist");
  Publisher publisher = simulation->transport().node().advertise("/model/rover/cmd_vel", "ignition.msgs.Twist");
  publisher.publish(*halt);
  simulation->step(10);
  EXPECT_EQ(odometry, before);
  place(*simulation, "scout", {0, 0, 0});
  simulation->step(1000);
  simulation->transport().dispatch();
  EXPECT_GE(odometry, before + 40);
  EXPECT_NEAR(simulation->world().model("rover")->links()[0].linearVelocity().norm(), speed, 1e-3);
}

TEST(LevelSensors, GoOnWithTheirNoise) {
  // a gyroscope bias of 5 rad/s with a correlation time of 0.1 s
  const auto simulation = play();
  std::vector<double> readings;
  const Subscription subscription = simulation->transport().node().subscribe<ignition::msgs::IMU>(
      "/imu", [&readings](const auto& message) { readings.push_back(message.angular_velocity().x()); });
  simulation->step(2000);
  visit(*simulation, 1000);
  EXPECT_EQ(readings.size(), 201U) << "it does not speak while it is set aside";
  EXPECT_GT(std::abs(readings.front()), 3);
  EXPECT_LT(std::abs(readings.back()), 0.01);
  simulation->step(100);
  simulation->transport().dispatch();
  ASSERT_GE(readings.size(), 211U);
  EXPECT_LT(std::abs(readings[201]), 0.01) << "it does not begin anew";
}

TEST(LevelState, LeavesNoTraceWhereItIsForged) {
  const auto simulation = play();
  simulation->step(100);
  place(*simulation, "scout", kFar);
  simulation->step(10);
  EXPECT_FALSE(simulation->world().model("rover"));
  const std::vector<std::byte> state = simulation->saveState();
  // a forged state sets aside a model that is in no level
  std::vector<std::byte> forged = state;
  const std::string_view member = "model crate", stranger = "model other";
  const auto found = std::ranges::search(forged, std::as_bytes(std::span(member)));
  ASSERT_FALSE(found.empty());
  std::ranges::copy(std::as_bytes(std::span(stranger)), found.begin());
  EXPECT_EQ(simulation->restoreState(test::withChecksum(forged)).error,
            "the saved state has unloaded levels that can't be here");
  EXPECT_EQ(simulation->saveState(), state);

  std::mt19937_64 random(46);
  for (int i = 0; i < 200; ++i) {
    const Outcome<void> restored = simulation->restoreState(test::forged(state, random));
    if (restored) {
      simulation->step(20);
      ASSERT_TRUE(simulation->restoreState(state)) << i;
    }
    ASSERT_EQ(simulation->saveState(), state) << i << ": " << restored.error;
  }
  place(*simulation, "scout", Vector3::Zero());
  simulation->step(10);
  EXPECT_TRUE(simulation->world().model("rover"));
}

TEST(LevelScene, IsToldWhoComesAndGoes) {
  const auto simulation = play();
  std::vector<std::string> come;
  std::vector<std::uint32_t> gone;
  Node node = simulation->transport().node();
  const Subscription scene = node.subscribe<ignition::msgs::Scene>("/world/w/scene/info", [&come](const auto& message) {
    for (const auto& model : message.model()) come.push_back(model.name());
  });
  const Subscription deletion = node.subscribe<ignition::msgs::UInt32_V>(
      "/world/w/scene/deletion",
      [&gone](const auto& message) { gone.insert(gone.end(), message.data().begin(), message.data().end()); });
  simulation->step(2);
  simulation->transport().dispatch();
  EXPECT_EQ(come.size(), 8U) << "all, for who is new";
  EXPECT_TRUE(gone.empty());
  const auto crate = static_cast<std::uint32_t>(simulation->world().model("crate")->id().value);
  come.clear();
  place(*simulation, "scout", kFar);
  simulation->step(2);
  simulation->transport().dispatch();
  EXPECT_EQ(gone.size(), 5U);
  EXPECT_NE(std::find(gone.begin(), gone.end(), crate), gone.end());
  EXPECT_TRUE(come.empty());
  place(*simulation, "scout", {0, 0, 0});
  simulation->step(2);
  simulation->transport().dispatch();
  EXPECT_EQ(come, (std::vector<std::string>{"rover", "crate", "lower", "upper", "pendulum"}));
  EXPECT_EQ(gone.size(), 5U);
}

TEST(LevelState, IsTheSameForAnyNumberOfThreadsAndAfterAReset) {
  const auto run = [](Simulation& simulation) {
    simulation.step(300);
    visit(simulation, 200);
    simulation.step(300);
    place(simulation, "scout", kFar);
    simulation.step(100);
    return simulation.stateHash();
  };
  const auto one = play(), two = play({.threads = 2, .levels = true});
  const std::uint64_t hash = run(*one);
  EXPECT_EQ(run(*two), hash);
  Diagnostics diagnostics;
  one->reset(diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
  const MessagePointer twist = newMessage("ignition.msgs.Twist");
  EXPECT_FALSE(parseMessage("linear: {x: 0.5}, angular: {z: 0.3}", *twist));
  one->transport().node().advertise("/model/rover/cmd_vel", "ignition.msgs.Twist").publish(*twist);
  EXPECT_EQ(run(*one), hash);
}

class LevelSave : public testing::Test {
 protected:
  /// Two boxes of the level are attached to each other, and the level is set aside.
  std::unique_ptr<Simulation> away() {
    auto simulation = play();
    simulation->step(400);
    World world = simulation->world();
    EXPECT_TRUE(world.attach(world.model("crate")->links()[0], world.model("lower")->links()[0]));
    simulation->step(5);
    EXPECT_TRUE(simulation->addPerformer("other"));
    place(*simulation, "scout", kFar);
    simulation->step(100);
    EXPECT_FALSE(world.model("crate"));
    return simulation;
  }
  static std::vector<std::uint64_t> goOn(Simulation& simulation) {
    std::vector<std::uint64_t> hashes = {simulation.stateHash()};
    simulation.step(50);
    place(simulation, "scout", {0, 0, 0});
    for (int i = 0; i < 3; ++i) {
      simulation.step(i == 0 ? 1 : 300);
      hashes.push_back(simulation.stateHash());
    }
    std::vector<Performer> performers;
    simulation.world().performers(performers);
    hashes.push_back(performers.size());
    return hashes;
  }
};

TEST_F(LevelSave, HasWhatIsSetAside) {
  const auto simulation = away();
  const std::vector<std::byte> state = simulation->saveState();
  const std::vector<std::uint64_t> hashes = goOn(*simulation);
  EXPECT_EQ(hashes.back(), 2U);
  // restored into a run in which the level is loaded
  ASSERT_TRUE(simulation->restoreState(state));
  EXPECT_FALSE(simulation->world().model("crate"));
  EXPECT_EQ(simulation->countSetAside(), 5U);
  EXPECT_EQ(goOn(*simulation), hashes);
  // restored into a run in which the level is unloaded
  place(*simulation, "scout", kFar);
  simulation->step(10);
  ASSERT_TRUE(simulation->restoreState(state));
  EXPECT_EQ(goOn(*simulation), hashes);
  // restored into another simulation
  const auto other = play();
  ASSERT_TRUE(other->restoreState(state));
  EXPECT_EQ(goOn(*other), hashes);
}

// A gripper and the object that it holds are set aside together.
TEST_F(LevelSave, HasWhatSystemsHoldThatRest) {
  std::string text = playground();
  text.replace(text.find("<ref>crate</ref>"), 16, "<ref>crate</ref><ref>gripper</ref>");
  text.replace(
      text.find("<model name='crate'>"), 0,
      "<model name='gripper'><static>true</static><link name='l'/><plugin "
      "filename='ignition-gazebo-detachable-joint-system' name='ignition::gazebo::systems::DetachableJoint'>"
      "<parent_link>l</parent_link><child_model>crate</child_model><child_link>l</child_link></plugin></model>");
  const auto simulation = test::simulate(text, {.levels = true});
  simulation->step(10);
  place(*simulation, "scout", kFar);
  simulation->step(10);
  const std::vector<std::byte> state = simulation->saveState();
  for (int i = 0; i < 2; ++i) {
    place(*simulation, "scout", {0, 0, 0});
    simulation->step(500);
    EXPECT_GT(simulation->world().model("crate")->pose().position.z(), 0.9) << "it is held";
    const MessagePointer nothing = newMessage("ignition.msgs.Empty");
    simulation->transport()
        .node()
        .advertise("/model/gripper/detachable_joint/detach", "ignition.msgs.Empty")
        .publish(*nothing);
    simulation->step(500);
    EXPECT_LT(simulation->world().model("crate")->pose().position.z(), 0.5) << "it is let go";
    ASSERT_TRUE(simulation->restoreState(state));
  }
}

TEST_F(LevelSave, OfALoadedLevelIsRestoredWhereItIsSetAside) {
  const auto simulation = play();
  simulation->step(400);
  const std::vector<std::byte> state = simulation->saveState();
  const std::vector<std::uint64_t> hashes = goOn(*simulation);
  place(*simulation, "scout", kFar);
  simulation->step(10);
  ASSERT_TRUE(simulation->restoreState(state));
  EXPECT_TRUE(simulation->world().model("crate"));
  EXPECT_EQ(goOn(*simulation), hashes);
  const auto other = away();
  ASSERT_TRUE(other->restoreState(state));
  EXPECT_EQ(goOn(*other), hashes);
}

TEST_F(LevelSave, IsRefusedWhereItDoesNotFitAndLeavesAllAsItWas) {
  const auto simulation = away();
  const std::vector<std::byte> state = simulation->saveState();
  const auto without = play({});
  without->step(3);
  const std::uint64_t before = without->stateHash();
  EXPECT_EQ(without->restoreState(state).error,
            "the saved state is of another world, or of other models, joints or systems");
  EXPECT_EQ(without->stateHash(), before);
  // the joint can't be restored, because a model of the file was replaced by an inserted one
  const auto other = play();
  other->step(400);
  World world = other->world();
  ASSERT_TRUE(world.detach(world.model("pendulum")->joints()[0]));
  ASSERT_TRUE(other->remove(*world.model("other")));
  Diagnostics diagnostics;
  ASSERT_TRUE(other->insertText("<sdf version='1.9'>" + kOther + "</sdf>", "t.sdf", {}, diagnostics));
  place(*other, "scout", kFar);
  other->step(100);
  const std::uint64_t hash = other->stateHash();
  EXPECT_EQ(other->restoreState(state).error, "the saved state has joints that can't be recreated here");
  EXPECT_EQ(other->stateHash(), hash);
  EXPECT_EQ(other->countSetAside(), 5U);
}

}  // namespace
}  // namespace pongsim
