#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/empty.pb.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/ask_service.hh"
#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::logical_audio_test {
namespace {

using ignition::msgs::Double;
using test::RunningWorld;

std::string plugin(const std::string& content) {
  return "<plugin filename='ignition-gazebo-logicalaudiosensorplugin-system' "
         "name='ignition::gazebo::systems::LogicalAudioSensorPlugin'>" +
         content + "</plugin>";
}

std::string model(const std::string& name, const std::string& place, const std::string& content) {
  return "<model name='" + name + "'><static>true</static><pose>" + place + " 0 0 0</pose><link name='l'/>" + content +
         "</model>";
}

std::string source(const std::string& id, const std::string& playing, const std::string& duration = "0") {
  return "<source><id>" + id + "</id><pose>0 0 0 0 0 0</pose><attenuation_function>linear</attenuation_function>" +
         "<attenuation_shape>sphere</attenuation_shape><inner_radius>3</inner_radius>" +
         "<falloff_distance>8</falloff_distance><volume_level>0.9</volume_level><playing>" + playing +
         "</playing><play_duration>" + duration + "</play_duration></source>";
}

std::string microphone(const std::string& id, const std::string& threshold = "0") {
  return "<microphone><id>" + id + "</id><pose>0.5 0 0 0 0 0</pose><volume_threshold>" + threshold +
         "</volume_threshold></microphone>";
}

std::string worldWith(const std::string& ofSource) {
  return model("speaker", "0 0 0", plugin(ofSource)) + model("near", "1 1 0", plugin(microphone("2", "0.1"))) +
         model("far", "10 1 0", plugin(microphone("1")));
}

std::vector<Double> hear(RunningWorld& world, const std::string& topic, std::uint64_t steps) {
  std::vector<Double> heard;
  const Subscription subscription = world.simulation().transport().node().subscribe<Double>(
      topic, [&heard](const Double& message) { heard.push_back(message); });
  world.step(steps);
  return heard;
}

void ask(RunningWorld& world, const std::string& service) {
  ignition::msgs::Boolean reply;
  const CallResult result = test::askService(world.simulation().transport(), service, ignition::msgs::Empty(), reply);
  EXPECT_TRUE(result) << result.error;
  EXPECT_TRUE(reply.data());
}

/// As Fortress's own test of the system tells it.
TEST(LogicalAudioSensorPlugin, IsHeardNearAndNotFar) {
  RunningWorld world(worldWith(source("1", "true")));
  std::vector<Double> near, far;
  world.listen("/model/near/sensor/mic_2/detection", near);
  world.listen("/model/far/sensor/mic_1/detection", far);
  world.step(100);
  ASSERT_EQ(near.size(), 100U);
  EXPECT_EQ(near[0].header().data(0).key(), "world/w/model/speaker/sensor/source_1");
  EXPECT_EQ(near[0].header().data(0).value_size(), 0);
  EXPECT_EQ(near[99].header().stamp().nsec(), 100'000'000);
  EXPECT_EQ(near[0].data(), 0.9);
  EXPECT_TRUE(far.empty());
}

TEST(LogicalAudioSensorPlugin, GetsSofterWithTheDistance) {
  RunningWorld world(model("speaker", "0 0 0", plugin(source("1", "true"))) +
                     model("mover", "0 0 0", plugin(microphone("1"))));
  for (const double x : {0.0, 3.0, 4.5, 6.0, 7.9}) {
    EXPECT_TRUE(world.model("mover").setPose({{x, 0, 0}, Quaternion::Identity()}));
    const std::vector<Double> heard = hear(world, "/model/mover/sensor/mic_1/detection", 1);
    // the microphone is half a metre ahead
    const double expected = 0.9 * std::clamp((8 - (x + 0.5)) / 5, 0.0, 1.0);
    ASSERT_EQ(heard.size(), expected > 0 ? 1U : 0U) << x;
    for (const Double& message : heard) EXPECT_NEAR(message.data(), expected, 1e-12) << x;
  }
}

TEST(LogicalAudioSensorPlugin, TurnsItsMicrophonesWithTheModel) {
  RunningWorld world(model("speaker", "0 0 0", plugin(source("1", "true"))) +
                     model("mover", "6 0 0", plugin(microphone("1"))));
  EXPECT_NEAR(hear(world, "/model/mover/sensor/mic_1/detection", 1).at(0).data(), 0.9 * 0.3, 1e-12);
  const Quaternion back(Eigen::AngleAxisd(std::acos(-1), Vector3::UnitZ()));
  EXPECT_TRUE(world.model("mover").setPose({{6, 0, 0}, back}));
  EXPECT_NEAR(hear(world, "/model/mover/sensor/mic_1/detection", 1).at(0).data(), 0.9 * 0.5, 1e-12);
}

TEST(LogicalAudioSensorPlugin, IsPlayedAndStoppedByServices) {
  RunningWorld world(worldWith(source("1", "true") + source("2", "false")));
  const std::string topic = "/model/near/sensor/mic_2/detection";
  const auto heard = [&] {
    std::vector<std::string> keys;
    for (const Double& message : hear(world, topic, 1)) {
      const std::string& key = message.header().data(0).key();
      keys.push_back(key.substr(key.rfind('_')));
    }
    return keys;
  };
  using Keys = std::vector<std::string>;
  EXPECT_EQ(heard(), Keys{"_1"});
  ask(world, "/model/speaker/sensor/source_2/play");
  EXPECT_EQ(heard(), (Keys{"_1", "_2"}));
  ask(world, "/model/speaker/sensor/source_1/stop");
  EXPECT_EQ(heard(), Keys{"_2"});
}

TEST(LogicalAudioSensorPlugin, StandsInAWorldAndInNestedModels) {
  RunningWorld world(plugin(source("1", "true") + microphone("1")) + "<model name='outer'><static>true</static>" +
                     model("inner", "0 0 0", plugin(microphone("1"))) + "</model>");
  EXPECT_EQ(hear(world, "/world/w/sensor/mic_1/detection", 1).at(0).header().data(0).key(), "world/w/sensor/source_1");
  EXPECT_EQ(hear(world, "/model/outer/model/inner/sensor/mic_1/detection", 1).size(), 1U);
  ask(world, "/world/w/sensor/source_1/stop");
  EXPECT_TRUE(hear(world, "/world/w/sensor/mic_1/detection", 1).empty());
}

TEST(LogicalAudioSensorPlugin, HearsModelsThatComeAndNotThoseThatHaveGone) {
  RunningWorld world(worldWith(source("1", "true")));
  const std::string topic = "/model/near/sensor/mic_2/detection";
  Diagnostics diagnostics;
  const auto later = world.simulation().insertText(
      "<sdf version='1.9'>" + model("later", "0 0 0", plugin(source("1", "true"))) + "</sdf>", "later.sdf", {},
      diagnostics);
  ASSERT_TRUE(later);
  EXPECT_EQ(hear(world, topic, 1).size(), 2U);
  EXPECT_TRUE(world.simulation().remove(world.model("speaker")));
  const std::vector<Double> heard = hear(world, topic, 1);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0].header().data(0).key(), "world/w/model/later/sensor/source_1");
}

TEST(LogicalAudioSensorPlugin, GoesOnFromASavedStateAndBeginsAgainAfterAReset) {
  RunningWorld world(worldWith(source("1", "true", "1"))), other(worldWith(source("1", "true", "1")));
  const std::string topic = "/model/near/sensor/mic_2/detection";
  EXPECT_EQ(hear(world, topic, 2000).size(), 1001U) << "a second, and the first step";
  ask(world, "/model/speaker/sensor/source_1/play");
  world.step(400);
  const std::vector<std::byte> state = world.simulation().saveState();
  EXPECT_EQ(hear(world, topic, 2000).size(), 601U);
  ASSERT_TRUE(other.simulation().restoreState(state));
  EXPECT_EQ(hear(other, topic, 2000).size(), 601U);
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  EXPECT_EQ(hear(world, topic, 2000).size(), 1001U);
}

TEST(LogicalAudioSensorPlugin, LeavesOutWhatItCantHaveAndKeepsTheRest) {
  const std::string left = "this <source> is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(plugin("<source><id>1</id></source>" + source("2", "maybe") +
                                                 source("3", "true") + source("3", "true") + microphone("1") +
                                                 microphone("1") + "<microphone><id>2</id></microphone>")),
            (std::vector<std::string>{"this <source> has no <pose>: it is where its parent is",
                                      left + "no <attenuation_function> is given",
                                      left + "<playing> is 'maybe', which is not 'true' or 'false'",
                                      left + "service '/world/w/sensor/source_3/play' is already offered",
                                      "this <microphone> is left out: there is already a microphone 1",
                                      "this <microphone> has no <pose>: it is where its parent is",
                                      "this <microphone> has no <volume_threshold>: it detects everything"}));
  RunningWorld world(plugin(source("3", "true") + microphone("1")));
  EXPECT_EQ(hear(world, "/world/w/sensor/mic_1/detection", 1).size(), 1U);
}

TEST(LogicalAudioSensorPlugin, OfFortressExampleIsHeard) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "examples/logical_audio_sensor_plugin.sdf");
  const std::vector<Double> heard = hear(world, "/model/green_box/sensor/mic_1/detection", 10);
  ASSERT_EQ(heard.size(), 10U);
  EXPECT_EQ(heard[0].header().data(0).key(), "world/logical_audio_sensor/model/red_box/sensor/source_1");
  // 2.55 m away, of the 4 m between 1 m and 5 m
  EXPECT_NEAR(heard[0].data(), 0.8 * (1 - (std::hypot(0.5, 2.5) - 1) / 4), 1e-3);
  ask(world, "/model/blue_box/sensor/source_1/play");
  EXPECT_EQ(hear(world, "/model/green_box/sensor/mic_1/detection", 1).size(), 2U);
}

TEST(LogicalAudioSensorPlugin, IsNotHeardFromAnUnloadedLevel) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(
      RunningWorld::textOf(
          "<gravity>0 0 0</gravity><model name='walker'><pose>100 0 0 0 0 0</pose><link name='l'/></model>" +
          model("speaker", "0 0 0", plugin(source("1", "true"))) + model("near", "1 1 0", plugin(microphone("2"))) +
          "<plugin name='gz::sim' filename='dummy'><performer name='p'><ref>walker</ref><geometry><box><size>1 1 1"
          "</size></box></geometry></performer><level name='hall'><pose>0 0 0 0 0 0</pose><geometry><box><size>30 30 30"
          "</size></box></geometry><ref>speaker</ref></level></plugin>"),
      "world.sdf", {.levels = true}, diagnostics);
  ASSERT_NE(simulation, nullptr);
  std::vector<Double> heard;
  const Subscription subscription = simulation->transport().node().subscribe<Double>(
      "/model/near/sensor/mic_2/detection", [&heard](const Double& message) { heard.push_back(message); });
  for (const bool isLoaded : {false, true, false, true}) {
    const Vector3 place(isLoaded ? 0 : 100, 0, 0);
    EXPECT_TRUE(simulation->world().model("walker")->setPose({place, Quaternion::Identity()}, AfterMove::kStop));
    simulation->step(2);
    simulation->transport().dispatch();
    EXPECT_EQ(simulation->isSetAside("speaker"), !isLoaded);
    heard.clear();
    simulation->step(10);
    simulation->transport().dispatch();
    EXPECT_EQ(heard.size(), isLoaded ? 10U : 0U);
  }
}

}  // namespace
}  // namespace pongsim::logical_audio_test
