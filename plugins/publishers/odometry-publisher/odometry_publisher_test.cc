#include <gtest/gtest.h>
#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/odometry_with_covariance.pb.h>
#include <ignition/msgs/pose_v.pb.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::odometry_publisher_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& parameters) {
  return R"(<gravity>0 0 0</gravity><model name="m"><pose>5 4 3 0 0 1.5707963267948966</pose>
    <link name="body"><inertial><mass>2</mass></inertial></link>
    <plugin filename="ignition-gazebo-odometry-publisher-system"
            name="ignition::gazebo::systems::OdometryPublisher">)" +
         parameters + "</plugin></model>";
}

class OdometryPublisherTest : public testing::Test {
 protected:
  RunningWorld& start(const std::string& parameters, const std::string& topic = "/model/m/odometry",
                      const std::string& tfTopic = "/model/m/pose") {
    world_ = std::make_unique<RunningWorld>(worldWith(parameters));
    world_->listen(topic, odometry_);
    world_->listen(tfTopic, tf_);
    return *world_;
  }

  std::unique_ptr<RunningWorld> world_;
  std::vector<ignition::msgs::Odometry> odometry_;
  std::vector<ignition::msgs::Pose_V> tf_;
};

TEST_F(OdometryPublisherTest, TellsWhereTheModelIsInTheWorld) {
  start("").step(100);
  ASSERT_EQ(odometry_.size(), 6U);
  const ignition::msgs::Odometry& last = odometry_.back();
  EXPECT_NEAR(last.pose().position().x(), 5, 1e-9);
  EXPECT_NEAR(last.pose().position().y(), 4, 1e-9);
  EXPECT_EQ(last.pose().position().z(), 0);
  EXPECT_NEAR(last.pose().orientation().z(), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(last.twist().linear().x(), 0, 1e-9);
  EXPECT_EQ(last.header().stamp().nsec(), 100'000'000);
  ASSERT_EQ(last.header().data_size(), 2);
  EXPECT_EQ(last.header().data(0).value(0), "m/odom");
  EXPECT_EQ(last.header().data(1).key(), "child_frame_id");
  EXPECT_EQ(last.header().data(1).value(0), "m/base_footprint");
}

TEST_F(OdometryPublisherTest, TellsVelocitiesInTheBase) {
  RunningWorld& world = start("<odom_publish_frequency>1000</odom_publish_frequency>");
  world.model("m").setVelocity({0, 2, 1}, {0, 0, 0.5});
  world.step(20);
  const ignition::msgs::Twist& twist = odometry_.back().twist();
  EXPECT_NEAR(twist.linear().x(), 2, 0.02);
  EXPECT_NEAR(twist.linear().y(), 0, 0.02);
  EXPECT_EQ(twist.linear().z(), 0);
  EXPECT_NEAR(twist.angular().z(), 0.5, 1e-3);
}

TEST_F(OdometryPublisherTest, TellsAllOfItInThreeDimensions) {
  RunningWorld& world = start("<dimensions>3</dimensions>");
  world.model("m").setVelocity({0, 2, 1}, {0, 0.25, 0});
  world.step(20);
  EXPECT_NEAR(odometry_.back().pose().position().z(), 3.02, 1e-3);
  EXPECT_NEAR(odometry_.back().twist().linear().x(), 2, 0.02);
  EXPECT_NEAR(odometry_.back().twist().linear().z(), 1, 0.02);
  EXPECT_NEAR(odometry_.back().twist().angular().x(), 0.25, 1e-3);
}

TEST_F(OdometryPublisherTest, TakesItsNamesTopicsAndOffset) {
  start(
      "<odom_frame>o</odom_frame><robot_base_frame>b</robot_base_frame><odom_topic>odom</odom_topic>"
      "<tf_topic>tf</tf_topic><xyz_offset>1 0 0</xyz_offset><rpy_offset>0 0 1</rpy_offset>"
      "<odom_publish_frequency>10</odom_publish_frequency>",
      "/odom", "/tf")
      .step(1000);
  EXPECT_EQ(odometry_.size(), 11U);
  ASSERT_EQ(tf_.size(), 11U);
  ASSERT_EQ(tf_.back().pose_size(), 1);
  const ignition::msgs::Pose& pose = tf_.back().pose(0);
  EXPECT_EQ(pose.header().data(0).value(0), "o");
  EXPECT_EQ(pose.header().data(1).value(0), "b");
  EXPECT_NEAR(pose.position().y(), 5, 1e-9);
  EXPECT_NEAR(2 * std::atan2(pose.orientation().z(), pose.orientation().w()), std::acos(0.0) + 1, 1e-9);
}

TEST_F(OdometryPublisherTest, AddsNoiseToVelocitiesOnly) {
  start("<gaussian_noise>0.5</gaussian_noise><odom_publish_frequency>0</odom_publish_frequency>").step(3000);
  ASSERT_EQ(odometry_.size(), 3000U);
  double squares = 0;
  for (const ignition::msgs::Odometry& message : odometry_) squares += std::pow(message.twist().linear().y(), 2);
  EXPECT_NEAR(std::sqrt(squares / 3000), 0.5, 0.03);
  EXPECT_NEAR(odometry_.back().pose().position().x(), 5, 1e-9);
}

TEST(OdometryPublisherCovariance, IsTheSquareOfTheNoise) {
  RunningWorld world(worldWith("<gaussian_noise>0.5</gaussian_noise>"));
  std::vector<ignition::msgs::OdometryWithCovariance> messages;
  world.listen("/model/m/odometry_with_covariance", messages);
  world.step(100);
  ASSERT_FALSE(messages.empty());
  const ignition::msgs::OdometryWithCovariance& message = messages.back();
  EXPECT_NEAR(message.pose_with_covariance().pose().position().x(), 5, 1e-9);
  EXPECT_TRUE(message.header().has_stamp());
  for (const auto* covariance :
       {&message.pose_with_covariance().covariance(), &message.twist_with_covariance().covariance()}) {
    ASSERT_EQ(covariance->data_size(), 36);
    for (int i = 0; i < 36; ++i) EXPECT_EQ(covariance->data(i), i % 7 == 0 ? 0.25F : 0.0F) << i;
  }
}

TEST(OdometryPublisherParameters, AreRefusedWithTheReason) {
  const std::string left = "odometry-publisher of m is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<dimensions>4</dimensions>")),
            std::vector<std::string>{left + "<dimensions> must be at most 3"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<gaussian_noise>-1</gaussian_noise>")),
            std::vector<std::string>{left + "<gaussian_noise> must be zero or more"});
}

}  // namespace
}  // namespace pongsim::odometry_publisher_test
