#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/imu.pb.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::imu_test {
namespace {

/// What a world holds beside the systems.
struct Content {
  std::string gravity = "0 0 -9.8";
  std::string environment;
  std::string modelPose;
  std::string link;
  std::string sensor;
};

std::string worldWith(const Content& content) {
  return R"(<sdf version="1.9"><world name="w"><gravity>)" + content.gravity + "</gravity>" + content.environment + R"(
    <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
    <plugin filename="ignition-gazebo-imu-system" name="ignition::gazebo::systems::Imu"/>
    <model name="m"><pose>)" +
         content.modelPose + R"(</pose><link name="l"><inertial><mass>2</mass></inertial>)" + content.link + R"(
      <sensor name="s" type="imu">)" +
         content.sensor + "</sensor></link></model></world></sdf>";
}

Vector3 vectorOf(const ignition::msgs::Vector3d& message) { return {message.x(), message.y(), message.z()}; }

Quaternion rotationOf(const ignition::msgs::Quaternion& message) {
  return {message.w(), message.x(), message.y(), message.z()};
}

class ImuTest : public testing::Test {
 protected:
  void start(const Content& content, const std::string& topic = "/world/w/model/m/link/l/sensor/s/imu",
             std::uint64_t seed = 0) {
    Diagnostics diagnostics;
    received_.clear();
    subscription_ = Subscription();
    simulation_ =
        Simulation::fromText(worldWith(content), "world.sdf", {.seed = seed, .transport = nullptr}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    ASSERT_NE(simulation_, nullptr);
    subscription_ = simulation_->transport().node().subscribe<ignition::msgs::IMU>(
        topic, [this](const auto& message) { received_.push_back(message); });
  }

  /// @return What was measured in a few steps, as text.
  std::string measured() {
    received_.clear();
    step(3);
    std::string text;
    for (const auto& message : received_) text += messageText(message);
    return text;
  }

  /// Steps until the message of the last step has come.
  void step(std::uint64_t count) {
    simulation_->step(count);
    simulation_->transport().dispatch();
  }

  Link link() { return simulation_->world().model("m")->link("l").value(); }

  std::unique_ptr<Simulation> simulation_;
  std::vector<ignition::msgs::IMU> received_;
  Subscription subscription_;
};

TEST_F(ImuTest, FeelsNothingInFreeFall) {
  start({.gravity = "0 0 -9.8", .environment = {}, .modelPose = "0 0 9 0.3 0.2 0.1", .link = {}, .sensor = {}});
  step(100);
  ASSERT_EQ(received_.size(), 100U);
  EXPECT_NEAR(vectorOf(received_.back().linear_acceleration()).norm(), 0, 1e-9);
  EXPECT_NEAR(vectorOf(received_.back().angular_velocity()).norm(), 0, 1e-9);
}

TEST_F(ImuTest, FeelsWhatHoldsItUp) {
  // its frame lies on the side: up is its y axis
  start({.gravity = "0 0 -9.8",
         .environment = {},
         .modelPose = {},
         .link = "<kinematic>true</kinematic>",
         .sensor = "<pose>0.1 0 0 1.5707963267948966 0 0</pose>"});
  step(10);
  EXPECT_NEAR((vectorOf(received_.back().linear_acceleration()) - Vector3(0, 9.8, 0)).norm(), 0, 1e-9);
}

TEST_F(ImuTest, FeelsAPushInItsOwnFrame) {
  start({.gravity = "0 0 0", .environment = {}, .modelPose = "0 0 0 0 0 1.5707963267948966", .link = {}, .sensor = {}});
  link().addWrench({0, 6, 0}, Vector3::Zero());
  step(1);
  EXPECT_NEAR((vectorOf(received_.back().linear_acceleration()) - Vector3(3, 0, 0)).norm(), 0, 1e-9);
}

TEST_F(ImuTest, FeelsItsTurningAndWhatPullsItInwards) {
  start({.gravity = "0 0 0", .environment = {}, .modelPose = {}, .link = {}, .sensor = "<pose>0.5 0 0 0 0 0</pose>"});
  link().setVelocity(Vector3::Zero(), {0, 0, 2});
  step(1000);
  const ignition::msgs::IMU& last = received_.back();
  EXPECT_NEAR((vectorOf(last.angular_velocity()) - Vector3(0, 0, 2)).norm(), 0, 1e-6);
  // w^2 r, to the length of a step
  EXPECT_NEAR((vectorOf(last.linear_acceleration()) - Vector3(-2, 0, 0)).norm(), 0, 4e-3);
  EXPECT_NEAR(rotationOf(last.orientation()).angularDistance(fromRollPitchYaw(0, 0, 2)), 0, 2e-3);
}

TEST_F(ImuTest, TellsItsOrientationSinceTheStart) {
  start({.gravity = "0 0 0", .environment = {}, .modelPose = "0 0 0 0.4 0.5 0.6", .link = {}, .sensor = {}});
  step(1);
  EXPECT_NEAR(rotationOf(received_.back().orientation()).angularDistance(Quaternion::Identity()), 0, 1e-7);
}

TEST_F(ImuTest, TellsItsOrientationInTheFrameThatTheFileAsksFor) {
  const double half = std::acos(-1);
  const std::vector<std::pair<std::string, Quaternion>> frames = {
      {"<localization>ENU</localization>", fromRollPitchYaw(0, 0, -0.1)},
      {"<localization>NWU</localization>", fromRollPitchYaw(0, 0, -half / 2 - 0.1)},
      {"<localization>NED</localization>",
       fromRollPitchYaw(half, 0, half / 2).conjugate() * fromRollPitchYaw(0, 0, -0.1)},
      {"<localization>CUSTOM</localization><custom_rpy parent_frame='world'>0.5 0 0</custom_rpy>",
       fromRollPitchYaw(-0.5, 0, 0) * fromRollPitchYaw(0, 0, -0.1)}};
  for (const auto& [frame, expected] : frames) {
    start({.gravity = "0 0 0",
           .environment = "<spherical_coordinates><heading_deg>5.729577951308232</heading_deg></spherical_coordinates>",
           .modelPose = {},
           .link = {},
           .sensor = "<imu><orientation_reference_frame>" + frame + "</orientation_reference_frame></imu>"});
    step(1);
    EXPECT_NEAR(rotationOf(received_.back().orientation()).angularDistance(expected), 0, 1e-7) << frame;
  }
}

TEST_F(ImuTest, LeavesTheOrientationOutIfItIsTold) {
  start({.gravity = "0 0 0",
         .environment = {},
         .modelPose = {},
         .link = {},
         .sensor = "<imu><enable_orientation>false</enable_orientation></imu>"});
  step(1);
  EXPECT_FALSE(received_.back().has_orientation());
}

TEST_F(ImuTest, NamesItselfAndCountsItsMessages) {
  start({.gravity = "0 0 0", .environment = {}, .modelPose = {}, .link = {}, .sensor = {}});
  step(2);
  const ignition::msgs::IMU& last = received_.back();
  EXPECT_EQ(last.entity_name(), "m::l::s");
  ASSERT_EQ(last.header().data_size(), 2);
  EXPECT_EQ(last.header().data(0).key(), "frame_id");
  EXPECT_EQ(last.header().data(0).value(0), "m::l::s");
  EXPECT_EQ(last.header().data(1).key(), "seq");
  EXPECT_EQ(last.header().data(1).value(0), "1");
  EXPECT_EQ(last.header().stamp().nsec(), 2'000'000);
}

TEST_F(ImuTest, SpeaksOnItsTopicAtItsRate) {
  start({.gravity = "0 0 0",
         .environment = {},
         .modelPose = {},
         .link = {},
         .sensor = "<topic>imu</topic><update_rate>30</update_rate><ignition_frame_id>f</ignition_frame_id>"},
        "/imu");
  step(990);
  // every 33 ms, and the first one at once
  EXPECT_EQ(received_.size(), 31U);
  EXPECT_EQ(received_.back().header().stamp().nsec(), 990'000'000);
  EXPECT_EQ(received_.back().header().data(0).value(0), "f");
}

TEST_F(ImuTest, SaysNothingWhilePaused) {
  start({.gravity = "0 0 0", .environment = {}, .modelPose = {}, .link = {}, .sensor = {}});
  simulation_->stepPaused();
  simulation_->stepPaused();
  EXPECT_TRUE(received_.empty());
}

constexpr const char* kNoisy =
    "<imu><linear_acceleration><x><noise type='gaussian'><mean>1</mean><stddev>0.5</stddev></noise></x>"
    "<z><noise type='gaussian'><bias_mean>3</bias_mean></noise></z></linear_acceleration></imu>";

TEST_F(ImuTest, AddsTheNoiseThatTheFileAsksFor) {
  start({.gravity = "0 0 0", .environment = {}, .modelPose = {}, .link = {}, .sensor = kNoisy});
  step(4000);
  double sum = 0, squares = 0;
  for (const ignition::msgs::IMU& message : received_) {
    const double x = message.linear_acceleration().x();
    sum += x;
    squares += (x - 1) * (x - 1);
    EXPECT_EQ(message.linear_acceleration().y(), 0);
    EXPECT_NEAR(std::abs(message.linear_acceleration().z()), 3, 1e-12);
  }
  EXPECT_NEAR(sum / 4000, 1, 0.04);
  EXPECT_NEAR(std::sqrt(squares / 4000), 0.5, 0.03);
}

TEST_F(ImuTest, RepeatsItsNoiseWithTheSameSeedOnly) {
  const auto run = [&](std::uint64_t seed) {
    start({.gravity = "0 0 0", .environment = {}, .modelPose = {}, .link = {}, .sensor = kNoisy},
          "/world/w/model/m/link/l/sensor/s/imu", seed);
    step(10);
    std::vector<double> values;
    for (const ignition::msgs::IMU& message : received_) values.push_back(message.linear_acceleration().x());
    return values;
  };
  EXPECT_EQ(run(7), run(7));
  EXPECT_NE(run(7), run(8));
}

TEST_F(ImuTest, OfFortressDemoTellsWhatItsLinkDoes) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  Diagnostics diagnostics;
  simulation_ = Simulation::fromFile(*worlds / "test/imu_rotating_demo.sdf", {}, diagnostics);
  ASSERT_NE(simulation_, nullptr);
  std::vector<Quaternion> started, enu;
  const auto listen = [&](const std::string& topic, std::vector<Quaternion>& into) {
    return simulation_->transport().node().subscribe<ignition::msgs::IMU>(
        topic, [&into](const auto& message) { into.push_back(rotationOf(message.orientation())); });
  };
  const Subscription first = listen("/imu_test_DEFAULT_1", started);
  const Subscription second = listen("/imu_test_ENU", enu);
  step(1000);
  ASSERT_EQ(started.size(), 2U);
  ASSERT_EQ(enu.size(), 2U);
  EXPECT_NEAR(started[0].angularDistance(Quaternion::Identity()), 0, 1e-6);
  EXPECT_NEAR(enu[1].angularDistance(simulation_->world().model("imu_model_1")->link("link")->pose().rotation), 0,
              1e-2);
}

TEST_F(ImuTest, DrawsTheSameNoiseAgainAfterAReset) {
  const auto begin = [this](std::uint64_t seed) {
    start({.gravity = "0 0 0", .environment = {}, .modelPose = "0 0 9 0 0 0", .link = {}, .sensor = kNoisy},
          "/world/w/model/m/link/l/sensor/s/imu", seed);
  };
  Diagnostics diagnostics;
  begin(5);
  const std::string first = measured();
  EXPECT_NE(measured(), first);
  simulation_->reset(diagnostics);
  EXPECT_EQ(measured(), first);
  simulation_->reset(diagnostics, 6);
  const std::string other = measured();
  EXPECT_NE(other, first);
  begin(6);
  EXPECT_EQ(measured(), other);
}

}  // namespace
}  // namespace pongsim::imu_test
