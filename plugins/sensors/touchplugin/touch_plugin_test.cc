#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/empty.pb.h>

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/simulation.hh"

namespace pongsim::touch_plugin_test {
namespace {

constexpr const char* kParameters =
    "<target>ball</target><time>0.1</time><namespace>plate</namespace><enabled>true</enabled>";

/// A ball that lies on a plate from the start.
std::string worldWith(const std::string& parameters, const std::string& sensor = "<collision>top</collision>") {
  return R"(<sdf version="1.9"><world name="w">
    <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
    <model name="ball"><pose>0 0 0.6 0 0 0</pose><link name="body"><inertial><mass>2</mass></inertial>
      <collision name="skin"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision></link></model>
    <model name="plate"><static>true</static><link name="slab">
      <collision name="top"><geometry><box><size>1 1 1</size></box></geometry></collision>)" +
         (sensor.empty() ? "" : "<sensor name='s' type='contact'><contact>" + sensor + "</contact></sensor>") +
         R"(</link>
      <plugin filename="ignition-gazebo-touchplugin-system" name="ignition::gazebo::systems::TouchPlugin">)" +
         parameters + "</plugin></model></world></sdf>";
}

std::vector<std::string> complaintsAbout(const std::string& world) {
  Diagnostics diagnostics;
  Simulation::fromText(world, "world.sdf", {}, diagnostics);
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : diagnostics.all()) messages.push_back(diagnostic.message);
  return messages;
}

class TouchPluginTest : public testing::Test {
 protected:
  void start(const std::string& world) {
    subscription_ = Subscription();
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(world, "world.sdf", {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    ASSERT_NE(simulation_, nullptr);
    subscription_ = simulation_->transport().node().subscribe<ignition::msgs::Boolean>(
        "/plate/touched", [this](const auto& message) { received_.push_back(message.data()); });
  }

  void enable(bool on) {
    std::atomic<bool> over = false;
    CallResult result;
    std::thread caller([&] {
      ignition::msgs::Boolean request;
      request.set_data(on);
      ignition::msgs::Empty reply;
      result = simulation_->transport().node().call("/plate/enable", request, reply, std::chrono::seconds(60));
      over = true;
      simulation_->transport().wake();
    });
    while (!over) simulation_->transport().dispatchFor(std::chrono::milliseconds(10));
    caller.join();
    EXPECT_TRUE(result) << result.error;
  }

  std::unique_ptr<Simulation> simulation_;
  std::vector<bool> received_;
  Subscription subscription_;
};

TEST_F(TouchPluginTest, SaysOnceThatATouchHasLasted) {
  start(worldWith(kParameters));
  simulation_->step(101);
  EXPECT_TRUE(received_.empty());
  simulation_->step(10);
  EXPECT_EQ(received_, std::vector<bool>{true});
  simulation_->step(1000);
  EXPECT_EQ(received_.size(), 1U);
}

TEST_F(TouchPluginTest, SaysItAgainOnceItIsEnabledAgain) {
  start(worldWith(kParameters));
  simulation_->step(200);
  enable(true);
  simulation_->step(200);
  EXPECT_EQ(received_.size(), 2U);
}

TEST_F(TouchPluginTest, WaitsUntilItIsEnabled) {
  start(worldWith("<target>ball</target><time>0.1</time><namespace>plate</namespace>"));
  simulation_->step(300);
  EXPECT_TRUE(received_.empty());
  enable(true);
  simulation_->step(50);
  enable(false);
  simulation_->step(300);
  EXPECT_TRUE(received_.empty());
}

TEST_F(TouchPluginTest, BeginsAnewWhereTheTouchIsBroken) {
  start(worldWith(kParameters));
  simulation_->step(80);
  // up and down again, within 60 ms
  simulation_->world().model("ball")->setVelocity({0, 0, 0.3}, Vector3::Zero());
  simulation_->step(130);
  EXPECT_TRUE(received_.empty());
  simulation_->step(100);
  EXPECT_EQ(received_.size(), 1U);
}

TEST_F(TouchPluginTest, CaresForItsTargetOnly) {
  start(
      worldWith("<target>model/ball/link/body/collision/skin</target><time>0</time><namespace>plate</namespace>"
                "<enabled>true</enabled>"));
  simulation_->step(10);
  EXPECT_EQ(received_.size(), 1U);
  EXPECT_EQ(complaintsAbout(worldWith("<target>cube</target><time>0</time><namespace>plate</namespace>")),
            std::vector<std::string>{"no collision in the world has 'cube' in its name"});
}

TEST_F(TouchPluginTest, HasANamespaceOfItsModelIfNoneIsGiven) {
  start(worldWith("<target>ball</target><time>0.1</time><enabled>true</enabled>"));
  const Subscription own = simulation_->transport().node().subscribe<ignition::msgs::Boolean>(
      "/model/plate/touch/touched", [this](const auto& message) { received_.push_back(message.data()); });
  simulation_->step(200);
  EXPECT_EQ(received_.size(), 1U);
}

TEST_F(TouchPluginTest, NeedsNoSensorIfItIsTold) {
  for (const char* names : {"", "<collision>top</collision>", "<collision>plate::slab::top</collision>"}) {
    received_.clear();
    start(worldWith(std::string(kParameters) + names +
                        "<create_contact_sensor_for_collision>true</create_contact_sensor_for_collision>",
                    ""));
    simulation_->step(200);
    EXPECT_EQ(received_.size(), 1U) << names;
  }
}

TEST_F(TouchPluginTest, CountsOnlyTheCollisionsThatItIsTold) {
  start(worldWith(std::string(kParameters) + "<collision>top</collision>"));
  simulation_->step(200);
  EXPECT_EQ(received_.size(), 1U);
  EXPECT_EQ(complaintsAbout(worldWith(std::string(kParameters) + "<collision>bottom</collision>"))[0],
            "touchplugin of plate is left out: model 'plate' has no such collision with a contact sensor");
  EXPECT_EQ(complaintsAbout(worldWith(std::string(kParameters) + "<collision>top</collision>", ""))[0],
            "collision 'plate::slab::top' has no contact sensor: it does not count");
}

TEST_F(TouchPluginTest, ReportsTheTouchesOfACopyToo) {
  start(worldWith(kParameters));
  Diagnostics diagnostics;
  testing::internal::CaptureStderr();
  ASSERT_TRUE(simulation_->insertCopy(*simulation_->world().model("plate"), {.name = "copy"}, diagnostics));
  std::string said = testing::internal::GetCapturedStderr();
  for (const Diagnostic& diagnostic : diagnostics.all()) said += diagnostic.message;
  EXPECT_NE(said.find("model 'copy' can't be enabled or disabled: service '/plate/enable' is already offered"),
            std::string::npos)
      << said;
  simulation_->step(200);
  EXPECT_EQ(received_.size(), 2U);
}

TEST(TouchPluginParameters, AreRefusedWithTheReason) {
  const std::string silent = "sensor 's' (contact) publishes nothing: no plugin of the world simulates it";
  EXPECT_EQ(complaintsAbout(worldWith("<time>1</time><namespace>n</namespace>")),
            (std::vector<std::string>{"touchplugin of plate is left out: no <target> is given", silent}));
  EXPECT_EQ(complaintsAbout(worldWith("<target>ball</target><time>-1</time><namespace>n</namespace>")),
            (std::vector<std::string>{"touchplugin of plate is left out: <time> must be zero or more", silent}));
  EXPECT_EQ(complaintsAbout(worldWith(kParameters, "")),
            std::vector<std::string>{
                "touchplugin of plate is left out: model 'plate' has no contact sensor with a <collision>"});
}

}  // namespace
}  // namespace pongsim::touch_plugin_test
