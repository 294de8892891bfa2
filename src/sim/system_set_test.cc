#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/imu.pb.h>
#include <ignition/msgs/pose_v.pb.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"
#include "pongsim/system.hh"

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

TEST(SystemSet, MissesNoPhysicsWhereARecordingIsPlayed) {
  const std::string text =
      "<sdf version='1.9'><world name='w'><plugin filename='no-such-log' "
      "name='ignition::gazebo::systems::LogPlayback'/>"
      "</world></sdf>";
  Diagnostics diagnostics;
  ASSERT_NE(Simulation::fromText(text, "world.sdf", {}, diagnostics), nullptr);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message, "plugin 'no-such-log' was not found: it is left out");
}

TEST(SystemSet, ReportsPluginsOfVisualsAndSensorsLikeOthers) {
  const auto plugin = [](const std::string& system) {
    return "<plugin filename='ignition-gazebo-" + system + "-system' name='ignition::gazebo::systems::X'/>";
  };
  const std::string text =
      "<sdf version='1.9'><world name='w'><plugin filename='ignition-gazebo-physics-system' "
      "name='ignition::gazebo::systems::Physics'/><model name='m'><link name='l'><visual name='v'>" +
      plugin("shader-param") + plugin("label") + "</visual><visual name='u'>" + plugin("shader-param") +
      "</visual><sensor name='s' type='contact'>" + plugin("nothing-of-ours") +
      "</sensor></link></model></world></sdf>";
  Diagnostics diagnostics;
  ASSERT_NE(Simulation::fromText(text, "world.sdf", {}, diagnostics), nullptr);
  std::vector<std::string> said;
  for (const Diagnostic& each : diagnostics.all()) said.push_back(each.message);
  EXPECT_TRUE(std::ranges::count(said,
                                 "shader-param has no effect: cameras run no shader programs, and draw the visual in "
                                 "its <material>") == 1)
      << testing::PrintToString(said);
  EXPECT_TRUE(
      std::ranges::count(said, "plugin 'ignition-gazebo-nothing-of-ours-system' was not found: it is left out") == 1)
      << testing::PrintToString(said);
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
  EXPECT_EQ(diagnostics.all()[0].message, "diff-drive is left out: it belongs in a <model>");
}

TEST(SystemSet, WarnsOfTwoThatPublishOnOneTopic) {
  const std::string text = R"(<sdf version="1.9"><world name="w">
    <plugin filename="ignition-gazebo-physics-system" name=""/>
    <model name="a"><link name="l"/>
      <plugin filename="ignition-gazebo-odometry-publisher-system" name=""><odom_topic>here</odom_topic></plugin></model>
    <model name="b"><link name="l"/>
      <plugin filename="ignition-gazebo-odometry-publisher-system" name=""><odom_topic>here</odom_topic></plugin></model>
    </world></sdf>)";
  Diagnostics diagnostics;
  EXPECT_NE(Simulation::fromText(text, "world.sdf", {}, diagnostics), nullptr);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(
      format(diagnostics.all()[0]),
      "world.sdf:6:7: warning: odometry-publisher of b publishes on '/here', and so does odometry-publisher of a in "
      "line 4\n  hint: subscribers get the messages of both");
}

TEST(SystemSet, WarnsOfParametersThatASystemDoesNotKnow) {
  const std::string text = world(R"(<plugin filename="ignition-gazebo-physics-system" name=""/>
    <plugin filename="ignition-gazebo-scene-broadcaster-system" name=""><dynamic_pose_herz>1</dynamic_pose_herz></plugin>)");
  Diagnostics diagnostics;
  EXPECT_NE(Simulation::fromText(text, "world.sdf", {}, diagnostics), nullptr);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(format(diagnostics.all()[0]),
            "world.sdf:2:73: warning: scene-broadcaster does not know <dynamic_pose_herz>\n"
            "  hint: did you mean 'dynamic_pose_hertz'?");
}

TEST(SystemSet, RunsWithoutPluginsThatAreNotThere) {
  Diagnostics diagnostics;
  const std::string physics = R"(<plugin filename="ignition-gazebo-physics-system" name=""/>)";
  EXPECT_NEAR(fallenAfterASecond(world(physics + R"(<plugin filename="no-such-thing" name="a"/>
                                                    <plugin filename="nor-such-a-one" name="b"/>
                                                    <plugin filename="__default__" name="__default__"/>)"),
                                 {}, diagnostics),
              4.9, 0.01);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].severity, Severity::kWarning);
  EXPECT_EQ(diagnostics.all()[0].message,
            "2 plugins were not found: they are left out: 'no-such-thing' (line 1), 'nor-such-a-one' (line 2)");
}

TEST(SystemSet, LeavesOutWhatGivesDataToSomethingElse) {
  const auto said = [](const std::string& content) {
    Diagnostics diagnostics;
    EXPECT_NE(Simulation::fromText(world(content), "world.sdf", {}, diagnostics), nullptr);
    std::vector<std::string> messages;
    for (const Diagnostic& diagnostic : diagnostics.all()) messages.push_back(diagnostic.message);
    return messages;
  };
  const std::string physics = R"(<plugin filename="ignition-gazebo-physics-system" name=""/>)";
  const std::string label = R"(<plugin filename="ignition-gazebo-label-system" name=""><label>7</label></plugin>)";
  const std::string thermal =
      R"(<plugin filename="ignition-gazebo-thermal-system" name=""><temperature>300</temperature></plugin>)";
  const auto model = [](const std::string& plugin) {
    return "<model name='n'><static>true</static><link name='l'/>" + plugin + "</model>";
  };
  EXPECT_EQ(said(physics + model(label)), std::vector<std::string>());
  EXPECT_EQ(said(physics + label),
            std::vector<std::string>{"label is left out: it belongs in a <model>, a <visual> or an <actor>"});
  EXPECT_EQ(said(physics + model(thermal)), std::vector<std::string>{"thermal is left out: it belongs in a <visual>"});
}

TEST(SystemSet, DoesNotRunWithoutASystemThatTheUserAskedFor) {
  Element plugin;
  plugin.name = "plugin";
  plugin.attributes = {{"filename", "no-such-thing", {}}, {"name", "a", {}}};
  Diagnostics diagnostics;
  EXPECT_EQ(fallenAfterASecond(world(""), {.systems = {plugin}}, diagnostics), -1);
  EXPECT_TRUE(diagnostics.hasErrors());
}

/// A model with an IMU.
/// @param imu A `<plugin>` for it inside the model, or empty.
std::string withImu(const std::string& name, const std::string& imu) {
  return "<model name='" + name + "'><static>true</static><link name='l'><sensor name='s' type='imu'><topic>" + name +
         "</topic></sensor></link>" + imu + "</model>";
}

constexpr const char* kImu = "<plugin filename='ignition-gazebo-imu-system' name='ignition::gazebo::systems::Imu'/>";

class BroughtSystems : public testing::Test {
 protected:
  void load(const std::string& models) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(
        "<sdf version='1.9'><world name='w'><plugin filename='ignition-gazebo-physics-"
        "system' name='ignition::gazebo::systems::Physics'/>" +
            models + "</world></sdf>",
        "world.sdf", {}, diagnostics);
    said_ = diagnostics.all();
    ASSERT_NE(simulation_, nullptr);
  }
  /// @return The number of messages received in ten steps; that of the last step arrives in the next one.
  int readings(const std::string& topic) {
    int count = 0;
    const Subscription subscription = simulation_->transport().node().subscribe<ignition::msgs::IMU>(
        topic, [&](const ignition::msgs::IMU&) { ++count; });
    simulation_->step(10);
    return count;
  }

  std::unique_ptr<Simulation> simulation_;
  std::vector<Diagnostic> said_;
};

TEST_F(BroughtSystems, AreOfTheWorldAndThereOnce) {
  load(withImu("a", kImu) + withImu("b", kImu) + withImu("c", ""));
  EXPECT_TRUE(said_.empty());
  for (const char* topic : {"/a", "/b", "/c"}) EXPECT_EQ(readings(topic), 9) << topic;
  // the system belongs to the world, so it stays when the model with its `<plugin>` is removed
  EXPECT_TRUE(simulation_->remove(simulation_->world().model("a").value()));
  EXPECT_EQ(readings("/b"), 9);
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  for (const char* topic : {"/a", "/b", "/c"}) EXPECT_EQ(readings(topic), 9) << topic;
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST_F(BroughtSystems, EndWithAResetIfAnInsertedModelBroughtThem) {
  load(withImu("a", ""));
  ASSERT_EQ(said_.size(), 1U);
  EXPECT_EQ(said_[0].message, "sensor 's' (imu) publishes nothing: no plugin of the world simulates it");
  const std::uint64_t before = simulation_->stateHash();
  Diagnostics diagnostics;
  EXPECT_TRUE(simulation_->insertText("<sdf version='1.9'>" + withImu("b", kImu) + "</sdf>", "b.sdf", {}, diagnostics));
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_EQ(readings("/a"), 9);
  EXPECT_EQ(readings("/b"), 9);
  simulation_->reset(diagnostics);
  EXPECT_EQ(simulation_->stateHash(), before);
  EXPECT_EQ(readings("/a"), 0);
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST_F(BroughtSystems, AreMissedByAnInsertedModelWithoutThem) {
  load("");
  Diagnostics diagnostics;
  EXPECT_TRUE(simulation_->insertText("<sdf version='1.9'>" + withImu("b", "") + "</sdf>", "b.sdf", {}, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message, "sensor 's' (imu) publishes nothing: no plugin of the world simulates it");
}

TEST_F(BroughtSystems, AreThoseOfSensorsOnly) {
  load(
      "<model name='m'><static>true</static><link name='l'/><plugin filename='ignition-gazebo-wind-effects-system' "
      "name='ignition::gazebo::systems::WindEffects'/></model>");
  ASSERT_EQ(said_.size(), 1U);
  EXPECT_EQ(said_[0].message, "wind-effects of m is left out: it belongs in a <world>");
}

TEST(SystemSet, GivesARobotWithoutAWorldWhatItsSensorsNeed) {
  Diagnostics diagnostics;
  const auto simulation =
      Simulation::fromText("<sdf version='1.9'>" + withImu("a", "") + "</sdf>", "robot.sdf", {}, diagnostics);
  ASSERT_NE(simulation, nullptr);
  EXPECT_TRUE(diagnostics.all().empty());
  int count = 0;
  const Subscription subscription =
      simulation->transport().node().subscribe<ignition::msgs::IMU>("/a", [&](const ignition::msgs::IMU&) { ++count; });
  simulation->step(10);
  EXPECT_EQ(count, 9);
}

/// Writes files, as recorders do, and fails to complete them.
class Incomplete final : public System {
 public:
  void configure(const SystemContext&) override {}
  void postUpdate(const StepInfo&) override { throw std::runtime_error("disk full"); }
  void finish() override { throw std::runtime_error("a.log is incomplete"); }
};

TEST(SystemSet, TellsAtTheEndWhoHasNotCompletedItsFiles) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(world(""), "world.sdf", {}, diagnostics);
  EXPECT_TRUE(simulation->finish());
  for (const char* name : {"one", "other"}) simulation->addSystem(name, std::make_unique<Incomplete>(), diagnostics);
  // switches both systems off
  simulation->step(10);
  EXPECT_EQ(simulation->finish().error, "one: a.log is incomplete; other: a.log is incomplete");
}

// Notifications of changes to a world's systems, and thereby to the systems of its models.
class ChangingSystems : public testing::Test {
 protected:
  static constexpr const char* kSpinner = R"(<sdf version="1.9"><model name="spinner">
    <link name="hub"><inertial><mass>1</mass></inertial></link>
    <joint name="root" type="revolute"><parent>world</parent><child>hub</child><axis><xyz>0 0 1</xyz></axis></joint>
    <plugin filename="ignition-gazebo-joint-controller-system" name="ignition::gazebo::systems::JointController">
      <joint_name>root</joint_name></plugin>
    <plugin filename="ignition-gazebo-joint-state-publisher-system"
            name="ignition::gazebo::systems::JointStatePublisher"/></model></sdf>)";
  static constexpr const char* kTopic = "/model/spinner/joint/root/cmd_vel";

  ChangingSystems() {
    Diagnostics diagnostics;
    std::string model = kSpinner;
    model = model.substr(model.find("<model"), model.rfind("</sdf>") - model.find("<model"));
    simulation_ = Simulation::fromText(
        "<sdf version='1.9'><world name='w'><plugin filename='ignition-gazebo-physics-system' "
        "name='ignition::gazebo::systems::Physics'/><plugin filename='ignition-gazebo-scene-broadcaster-system' "
        "name='ignition::gazebo::systems::SceneBroadcaster'/>" +
            model + "</world></sdf>",
        "world.sdf", {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    poses_ = simulation_->transport().node().subscribe<ignition::msgs::Pose_V>(
        "/world/w/pose/info", [this](const ignition::msgs::Pose_V& message) {
          models_.clear();
          for (const ignition::msgs::Pose& pose : message.pose()) models_ += pose.name() + " ";
        });
    speed_ = simulation_->transport().node().advertise<ignition::msgs::Double>(kTopic);
  }

  Model spinner() { return simulation_->world().model("spinner").value(); }
  void command(double speed) {
    ignition::msgs::Double message;
    message.set_data(speed);
    speed_.publish(message);
  }
  void step() { simulation_->step(20); }
  void reset() {
    Diagnostics diagnostics;
    simulation_->reset(diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  }

  std::unique_ptr<Simulation> simulation_;
  std::string models_;
  Subscription poses_;
  Publisher speed_;
};

TEST_F(ChangingSystems, GoWithTheirModelAndComeWithIt) {
  EXPECT_TRUE(speed_.hasSubscribers());
  EXPECT_TRUE(simulation_->remove(spinner()));
  EXPECT_FALSE(speed_.hasSubscribers());
  step();
  EXPECT_EQ(models_, "");

  Diagnostics diagnostics;
  ASSERT_TRUE(simulation_->insertText(kSpinner, "spinner.sdf", {}, diagnostics));
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_TRUE(speed_.hasSubscribers());
  command(3);
  step();
  EXPECT_NEAR(spinner().joint("root")->velocity(), 3, 1e-6);
  EXPECT_EQ(models_, "spinner hub ");
}

TEST_F(ChangingSystems, AreWhatTheyWereAfterAReset) {
  command(3);
  step();
  const std::uint64_t first = simulation_->stateHash();
  reset();
  command(3);
  step();
  EXPECT_EQ(simulation_->stateHash(), first);

  EXPECT_TRUE(simulation_->remove(spinner()));
  step();
  reset();
  EXPECT_TRUE(speed_.hasSubscribers());
  command(3);
  step();
  EXPECT_EQ(simulation_->stateHash(), first);
  EXPECT_EQ(models_, "spinner hub ");
}

TEST_F(ChangingSystems, OfAnInsertedModelThatCanNotBeHadAreLeftOut) {
  Diagnostics diagnostics;
  const std::string text = R"(<sdf version="1.9"><model name="m"><link name="l"/>
    <plugin filename="no-such-system" name="a"/></model></sdf>)";
  EXPECT_TRUE(simulation_->insertText(text, "m.sdf", {}, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message, "plugin 'no-such-system' was not found: it is left out");
  step();
  EXPECT_EQ(models_, "spinner m hub l ");
}

}  // namespace
}  // namespace pongsim
