#include <gtest/gtest.h>
#include <ignition/msgs/pose_v.pb.h>

#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::pose_publisher_test {
namespace {

using test::RunningWorld;
using Names = std::vector<std::string>;

std::string worldWith(const std::string& parameters) {
  return R"(<gravity>0 0 0</gravity><model name="m"><pose>0 0 7 0 0 0</pose>
    <link name="base"><pose>1 0 0 0 0 0</pose><inertial><mass>1</mass></inertial>
      <visual name="look"><pose>0 2 0 0 0 0</pose><geometry><sphere/></geometry></visual>
      <collision name="skin"><pose>0 3 0 0 0 0</pose>
        <geometry><sphere><radius>0.01</radius></sphere></geometry></collision>
      <sensor name="feel" type="imu"><pose>0 4 0 0 0 0</pose></sensor></link>
    <plugin filename="ignition-gazebo-imu-system" name="ignition::gazebo::systems::Imu"/>
    <link name="arm"><pose>5 0 0 0 0 0</pose><inertial><mass>1</mass></inertial></link>
    <link name="bolt"><inertial><mass>1</mass></inertial></link>
    <joint name="hinge" type="revolute"><parent>base</parent><child>arm</child><axis><xyz>0 1 0</xyz></axis></joint>
    <joint name="weld" type="fixed"><parent>base</parent><child>bolt</child></joint>
    <model name="inner"><pose>0 0 6 0 0 0</pose><link name="tip"><inertial><mass>1</mass></inertial></link></model>
    <plugin filename="ignition-gazebo-pose-publisher-system" name="ignition::gazebo::systems::PosePublisher">)" +
         parameters + "</plugin></model>";
}

/// "frame > entity" of each message.
Names namesOf(const std::vector<ignition::msgs::Pose>& poses) {
  Names names;
  for (const ignition::msgs::Pose& pose : poses) {
    EXPECT_EQ(pose.header().data(0).key(), "frame_id");
    EXPECT_EQ(pose.header().data(1).key(), "child_frame_id");
    EXPECT_EQ(pose.header().data(1).value(0), pose.name());
    names.push_back(pose.header().data(0).value(0) + " > " + pose.name());
  }
  return names;
}

TEST(PosePublisher, TellsOfLinksInTheirModel) {
  RunningWorld world(worldWith(""));
  std::vector<ignition::msgs::Pose> poses;
  world.listen("/model/m/pose", poses);
  world.step(1);
  EXPECT_EQ(namesOf(poses), (Names{"m > m::base", "m > m::arm", "m > m::bolt", "m::inner > m::inner::tip"}));
  EXPECT_NEAR(poses.at(0).position().x(), 1, 1e-9);
  EXPECT_NEAR(poses.at(0).position().z(), 0, 1e-9);
  EXPECT_EQ(poses.at(0).header().stamp().nsec(), 1'000'000);
  world.step(1);
  EXPECT_EQ(poses.size(), 8U);
}

TEST(PosePublisher, TellsOfWhatItIsToldTo) {
  RunningWorld world(
      worldWith("<publish_link_pose>false</publish_link_pose><publish_visual_pose>true</publish_visual_pose>"
                "<publish_collision_pose>true</publish_collision_pose><publish_sensor_pose>true</publish_sensor_pose>"
                "<publish_nested_model_pose>true</publish_nested_model_pose>"));
  std::vector<ignition::msgs::Pose> poses;
  world.listen("/model/m/pose", poses);
  world.step(1);
  EXPECT_EQ(namesOf(poses), (Names{"w > m", "m::base > m::base::look", "m::base > m::base::skin",
                                   "m::base > m::base::feel", "m > m::inner"}));
  EXPECT_NEAR(poses.at(0).position().z(), 7, 1e-9);
  EXPECT_NEAR(poses.at(1).position().y(), 2, 1e-9);
  EXPECT_NEAR(poses.at(2).position().y(), 3, 1e-9);
  EXPECT_NEAR(poses.at(3).position().y(), 4, 1e-9);
  EXPECT_NEAR(poses.at(4).position().z(), 6, 1e-9);
}

TEST(PosePublisher, SplitsWhatMovesFromWhatDoesNot) {
  RunningWorld world(
      worldWith("<static_publisher>true</static_publisher><use_pose_vector_msg>true</use_pose_vector_msg>"
                "<update_frequency>100</update_frequency>"
                "<static_update_frequency>10</static_update_frequency>"));
  std::vector<ignition::msgs::Pose_V> moving, still;
  world.listen("/model/m/pose", moving);
  world.listen("/model/m/pose_static", still);
  world.step(1000);
  EXPECT_EQ(moving.size(), 101U);
  EXPECT_EQ(still.size(), 11U);
  ASSERT_EQ(moving.back().pose_size(), 1);
  EXPECT_EQ(moving.back().pose(0).name(), "m::arm");
  EXPECT_EQ(moving.back().header().stamp().sec(), 1);
  EXPECT_EQ(still.back().pose_size(), 3);

  // who comes later is told at once of what does not change
  world.step(5);
  std::vector<ignition::msgs::Pose_V> movingLater, stillLater;
  world.listen("/model/m/pose", movingLater);
  world.listen("/model/m/pose_static", stillLater);
  world.step(2);
  EXPECT_EQ(movingLater.size(), 0U);
  ASSERT_EQ(stillLater.size(), 1U);
  EXPECT_EQ(stillLater[0].pose_size(), 3);
}

TEST(PosePublisher, OfFortressExampleSpeaks) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "examples/pose_publisher.sdf");
  std::vector<ignition::msgs::Pose> poses;
  world.listen("/model/double_pendulum_with_base/pose", poses);
  world.step(1000);
  ASSERT_FALSE(poses.empty());
  for (const std::string& name : namesOf(poses)) {
    EXPECT_EQ(name.rfind("double_pendulum_with_base > double_pendulum_with_base::", 0), 0U) << name;
  }
}

}  // namespace
}  // namespace pongsim::pose_publisher_test
