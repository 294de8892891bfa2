#include <gtest/gtest.h>
#include <ignition/msgs/pose.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::performer_detector_test {
namespace {

using test::RunningWorld;

constexpr const char* kBox = "<geometry><box><size>1 2 3</size></box></geometry>";

/// A ball of a metre that performs, and a gate at x = 4 that is turned about z.
std::string worldWith(const std::string& parameters) {
  return R"(<gravity>0 0 0</gravity><plugin filename="ignition-gazebo" name="gz::sim"><performer name="p">
      <ref>ball</ref><geometry><box><size>1 1 1</size></box></geometry></performer></plugin>
    <model name="ball"><link name="l"><inertial><mass>1</mass></inertial></link></model>
    <model name="gate"><static>true</static><pose>4 0 0 0 0 1.5707963267948966</pose><link name="l"/>
      <plugin filename="ignition-gazebo-performer-detector-system"
              name="ignition::gazebo::systems::PerformerDetector">)" +
         parameters + "</plugin></model>";
}

class PerformerDetectorTest : public testing::Test {
 protected:
  void start(const std::string& parameters = kBox, const std::string& topic = "/model/gate/performer_detector/status") {
    world_.emplace(worldWith(parameters));
    world_->listen(topic, messages_);
  }
  void put(const Vector3& position) {
    world_->model("ball").setPose({position, Quaternion::Identity()});
    world_->step(2);
  }
  std::string header(std::size_t message, const std::string& key) {
    for (const auto& data : messages_.at(message).header().data()) {
      if (data.key() == key) return data.value(0);
    }
    return "none";
  }

  std::optional<RunningWorld> world_;
  std::vector<ignition::msgs::Pose> messages_;
};

TEST_F(PerformerDetectorTest, TellsOnceThatAPerformerComesAndGoes) {
  start();
  put({2.99, 0, 0});
  EXPECT_TRUE(messages_.empty());
  put({3.01, 0, 0.5});
  ASSERT_EQ(messages_.size(), 1U);
  EXPECT_EQ(messages_[0].name(), "ball");
  EXPECT_GT(messages_[0].id(), 0U);
  EXPECT_EQ(header(0, "frame_id"), "gate");
  EXPECT_EQ(header(0, "state"), "1");
  EXPECT_EQ(header(0, "count"), "1");
  // in the gate's frame, which is turned
  EXPECT_NEAR(messages_[0].position().x(), 0, 1e-9);
  EXPECT_NEAR(messages_[0].position().y(), 0.99, 1e-9);
  EXPECT_NEAR(messages_[0].position().z(), 0.5, 1e-9);
  put({4, 0, 0});
  EXPECT_EQ(messages_.size(), 1U);
  put({4, 1.51, 0});
  ASSERT_EQ(messages_.size(), 2U);
  EXPECT_EQ(header(1, "state"), "0");
  EXPECT_EQ(header(1, "count"), "0");
}

// The box is moved in the turned frame of the gate, but lies along the axes of the world.
TEST_F(PerformerDetectorTest, LooksIntoABoxAsideOfItsModel) {
  start(std::string(kBox) + "<pose>10 0 0 0.1 0.2 0.3</pose>");
  put({4, 8.51, 0});
  EXPECT_EQ(messages_.size(), 1U);
  put({5.01, 10, 0});
  EXPECT_EQ(messages_.size(), 2U);
}

TEST_F(PerformerDetectorTest, AddsToTheHeaderWhatItIsTold) {
  start(std::string(kBox) +
            "<topic>seen</topic><header_data><key>place</key><value>hall</value></header_data>"
            "<header_data><key>door</key><value>1</value></header_data>"
            "<header_data><key>door</key><value>2</value></header_data>",
        "/seen");
  put({4, 0, 0});
  ASSERT_EQ(messages_.size(), 1U);
  EXPECT_EQ(header(0, "place"), "hall");
  EXPECT_EQ(header(0, "door"), "2");
  EXPECT_EQ(messages_[0].header().data_size(), 5);
}

TEST_F(PerformerDetectorTest, ForgetsWhoIsRemovedAndBeginsAnewAfterAReset) {
  start();
  put({4, 0, 0});
  EXPECT_EQ(messages_.size(), 1U);
  EXPECT_TRUE(world_->simulation().remove(world_->model("ball")));
  world_->step(2);
  EXPECT_EQ(messages_.size(), 1U);
  Diagnostics diagnostics;
  world_->simulation().reset(diagnostics);
  put({4, 0, 0});
  ASSERT_EQ(messages_.size(), 2U);
  EXPECT_EQ(header(1, "count"), "1");
}

TEST_F(PerformerDetectorTest, KnowsFromASavedStateWhoIsThere) {
  start();
  put({4, 0, 0});
  const std::vector<std::byte> there = world_->simulation().saveState();
  put({0, 0, 0});
  EXPECT_EQ(messages_.size(), 2U);
  EXPECT_TRUE(world_->simulation().restoreState(there));
  world_->step(2);
  EXPECT_EQ(messages_.size(), 2U);
  put({0, 0, 0});
  EXPECT_EQ(messages_.size(), 3U);
}

TEST(PerformerDetector, SaysWhatIsWrong) {
  const std::string left = "performer-detector of gate is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("")), std::vector<std::string>{left + "no <geometry> is given"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<geometry><sphere><radius>1</radius></sphere></geometry>")),
            std::vector<std::string>{left + "no <geometry> is given"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<geometry><box><size>1 nan 1</size></box></geometry>")),
            std::vector<std::string>{left + "<size> must be three lengths"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(std::string(kBox) + "<pose>1 2</pose>")),
            std::vector<std::string>{left + "<pose> must be six numbers: x y z roll pitch yaw"});
  EXPECT_EQ(RunningWorld::complaintsAbout(
                worldWith(std::string(kBox) + "<header_data><key>k</key></header_data><header_data/>")),
            (std::vector<std::string>{"this <header_data> has no <value>: it is left out",
                                      "this <header_data> has no <key>: it is left out"}));
}

// As Fortress's own test of this world has it: where the vehicle is when it comes and goes.
TEST(PerformerDetector, OfFortressTestWorldSeesTheVehiclePass) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "test/performer_detector.sdf");
  std::vector<ignition::msgs::Pose> messages;
  world.listen("/performer_detector", messages);
  ignition::msgs::Twist twist;
  twist.mutable_linear()->set_x(2);
  world.tell("/model/vehicle_blue/cmd_vel", twist);
  world.step(6001);
  ASSERT_EQ(messages.size(), 4U);
  const double expected[][2] = {{-3, 2}, {-2.5, -1}, {3, 2}, {2.5, -1}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(messages[i].header().data(0).value(0), i % 2 == 0 ? "detector1" : "detector2");
    EXPECT_EQ(messages[i].header().data(1).value(0), i < 2 ? "1" : "0");
    EXPECT_EQ(messages[i].header().data_size(), i % 2 == 0 ? 5 : 3);
    EXPECT_NEAR(messages[i].position().x(), expected[i][0], 1e-2);
    EXPECT_NEAR(messages[i].position().y(), expected[i][1], 1e-2);
  }
}

}  // namespace
}  // namespace pongsim::performer_detector_test
