#include <gtest/gtest.h>
#include <ignition/msgs/float.pb.h>
#include <ignition/msgs/joint_trajectory.pb.h>

#include <string>
#include <vector>

#include "pongsim/message.hh"
#include "support/running_world.hh"

namespace pongsim::joint_trajectory_controller_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& parameters, const std::string& attributes = "") {
  return R"(<gravity>0 0 0</gravity><model name="m">
    <link name="base"><inertial><mass>1</mass></inertial></link>
    <link name="arm"><inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial></link>
    <link name="hand"><inertial><mass>1</mass></inertial></link>
    <joint name="hold" type="fixed"><parent>world</parent><child>base</child></joint>
    <joint name="hinge" type="revolute"><parent>base</parent><child>arm</child><axis><xyz>0 0 1</xyz></axis></joint>
    <joint name="slide" type="prismatic"><parent>base</parent><child>hand</child><axis><xyz>0 0 1</xyz></axis></joint>
    <plugin filename="ignition-gazebo-joint-trajectory-controller-system"
            name="ignition::gazebo::systems::JointTrajectoryController" )" +
         attributes + ">" + parameters + "</plugin></model>";
}

constexpr const char* kGains =
    "<position_p_gain>40</position_p_gain><position_d_gain>4</position_d_gain>"
    "<position_p_gain>400</position_p_gain><position_d_gain>40</position_d_gain>";
constexpr const char* kTopic = "/model/m/joint_trajectory";

ignition::msgs::JointTrajectory trajectory(const std::string& text) {
  ignition::msgs::JointTrajectory message;
  EXPECT_FALSE(parseMessage(text, message));
  return message;
}

double position(RunningWorld& world, const char* joint) { return world.model("m").joint(joint)->position(); }

TEST(JointTrajectoryController, TakesItsJointsFromPointToPoint) {
  RunningWorld world(worldWith(kGains));
  std::vector<ignition::msgs::Float> progress;
  world.listen("/model/m/joint_trajectory_progress", progress);
  world.tell(kTopic, trajectory("joint_names: ['slide', 'hinge'] points { positions: [0.2, 1] "
                                "time_from_start { sec: 2 } } points { positions: [-0.1, -1] "
                                "time_from_start { sec: 4 } }"));
  world.step(1990);
  EXPECT_NEAR(position(world, "slide"), 0.2, 0.01);
  EXPECT_NEAR(position(world, "hinge"), 1, 0.01);
  world.step(2500);
  EXPECT_NEAR(position(world, "slide"), -0.1, 0.01);
  EXPECT_NEAR(position(world, "hinge"), -1, 0.01);
  ASSERT_EQ(progress.size(), 2U);
  EXPECT_EQ(progress[0].data(), 0.5F);
  EXPECT_EQ(progress[1].data(), 1.0F);
}

TEST(JointTrajectoryController, HoldsTheInitialPositionsOfTheJointsItIsGiven) {
  RunningWorld world(
      worldWith("<joint_name>slide</joint_name><initial_position>0.3</initial_position>"
                "<position_p_gain>400</position_p_gain><position_d_gain>40</position_d_gain>"));
  world.step(3000);
  EXPECT_NEAR(position(world, "slide"), 0.3, 0.01);
  EXPECT_EQ(position(world, "hinge"), 0);
}

TEST(JointTrajectoryController, ControlsVelocitiesAndAddsEfforts) {
  RunningWorld world(worldWith("<joint_name>hinge</joint_name><velocity_p_gain>2</velocity_p_gain><topic>go</topic>"));
  world.tell("/go", trajectory("joint_names: 'hinge' points { velocities: 3 time_from_start { sec: 1 } }"));
  world.step(1000);
  EXPECT_NEAR(world.model("m").joint("hinge")->velocity(), 3, 0.01);
  world.tell("/go", trajectory("joint_names: 'hinge' points { effort: 1 time_from_start { sec: 1 } }"));
  world.step(1000);
  // 2 N m s of gain against 1 N m
  EXPECT_NEAR(world.model("m").joint("hinge")->velocity(), 3.5, 0.01);
}

TEST(JointTrajectoryController, WaitsForTheStampIfItIsTold) {
  RunningWorld world(worldWith(kGains, "use_header_start_time='true'"));
  world.tell(kTopic, trajectory("header { stamp { sec: 1 } } joint_names: 'hinge' points { positions: 1 "
                                "time_from_start { sec: 1 } }"));
  world.step(990);
  EXPECT_NEAR(position(world, "hinge"), 0, 1e-6);
  world.step(2000);
  EXPECT_NEAR(position(world, "hinge"), 1, 0.01);
}

TEST(JointTrajectoryController, IgnoresWhatIsNoTrajectory) {
  RunningWorld world(worldWith(kGains));
  testing::internal::CaptureStderr();
  world.tell(kTopic, trajectory("joint_names: 'knee' points { positions: 1 time_from_start { sec: 1 } }"));
  world.tell(kTopic, trajectory("joint_names: 'hinge'"));
  world.step(500);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("a trajectory was ignored: joint 'knee' is not controlled"), std::string::npos) << said;
  EXPECT_NE(said.find("a trajectory was ignored: it has no points"), std::string::npos) << said;
  EXPECT_NEAR(position(world, "hinge"), 0, 1e-6);
}

TEST(JointTrajectoryController, RefusesAbsurdTrajectoriesAndGoesOn) {
  for (const char* values : {"positions: #", "velocities: #", "effort: #"}) {
    RunningWorld world(worldWith(kGains));
    world.tellAbsurdities(kTopic, "ignition.msgs.JointTrajectory",
                          std::string("joint_names: 'hinge' points {") + values + " time_from_start {nsec: 1}}");
    world.tell(kTopic, trajectory("joint_names: 'hinge' points {positions: 1 time_from_start {sec: 4000000001}}"));
    world.step(500);
    EXPECT_NEAR(position(world, "hinge"), 0, 1e-6);
    world.tell(kTopic, trajectory("joint_names: 'hinge' points {positions: 1 time_from_start {sec: 1}}"));
    world.step(2000);
    EXPECT_NEAR(position(world, "hinge"), 1, 0.01);
  }
}

TEST(JointTrajectoryController, IsLeftOutWithTheReason) {
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<joint_name>knee</joint_name>")),
            std::vector<std::string>{
                "joint-trajectory-controller of m is left out: <joint_name> 'knee' is not a joint of model 'm'"});
}

}  // namespace
}  // namespace pongsim::joint_trajectory_controller_test
