#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::joint_position_controller_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& parameters) {
  return test::hingeWith("joint-position-controller", "JointPositionController",
                         "<joint_name>hinge</joint_name>" + parameters);
}

constexpr const char* kGains = "<p_gain>10</p_gain><i_gain>0</i_gain><d_gain>2</d_gain>";
constexpr const char* kTopic = "/model/m/joint/hinge/0/cmd_pos";

double angle(RunningWorld& world) { return world.model("m").joint("hinge")->position(); }

TEST(JointPositionController, SettlesAtThePositionItIsTold) {
  RunningWorld world(worldWith(kGains));
  world.step(100);
  EXPECT_NEAR(angle(world), 0, 1e-9);
  world.tellNumber(kTopic, -1);
  world.step(4000);
  EXPECT_NEAR(angle(world), -1, 1e-3);
  EXPECT_NEAR(world.model("m").joint("hinge")->velocity(), 0, 1e-3);
}

TEST(JointPositionController, BeginsAtItsInitialPosition) {
  RunningWorld world(worldWith(std::string(kGains) + "<initial_position>0.5</initial_position>"));
  world.step(4000);
  EXPECT_NEAR(angle(world), 0.5, 1e-3);
}

TEST(JointPositionController, PushesNoHarderThanItMay) {
  RunningWorld world(
      worldWith("<p_gain>10</p_gain><i_gain>0</i_gain><d_gain>0</d_gain><cmd_max>0.2</cmd_max>"
                "<topic>cmd</topic>"));
  world.tellNumber("/cmd", 1);
  world.step(101);
  // 0.2 N m on 0.1 kg m^2 for 0.1 s
  EXPECT_NEAR(world.model("m").joint("hinge")->velocity(), 0.2, 0.005);
}

TEST(JointPositionController, MovesAtALimitedVelocityIfItIsTold) {
  RunningWorld world(
      worldWith("<use_velocity_commands>true</use_velocity_commands><cmd_max>0.5</cmd_max><cmd_min>-0.5</cmd_min>"));
  world.tellNumber(kTopic, 1);
  world.step(1000);
  EXPECT_NEAR(world.model("m").joint("hinge")->velocity(), 0.5, 1e-6);
  EXPECT_NEAR(angle(world), 0.5, 1e-3);
  world.step(2000);
  EXPECT_NEAR(angle(world), 1, 1e-6);
}

TEST(JointPositionController, ListensToTheTopicOrTheActuatorThatItIsTold) {
  for (const auto& [parameters, topic] : std::vector<std::pair<std::string, std::string>>{
           {"<sub_topic>servo_0</sub_topic>", "/model/m/servo_0"},
           {"<sub_topic>servo_0</sub_topic><topic>servo</topic>", "/servo"},
           {"<use_actuator_msg>1</use_actuator_msg><actuator_number>1</actuator_number>", "/actuators"}}) {
    RunningWorld world(worldWith(kGains + parameters));
    if (topic == "/actuators") {
      world.tellText(topic, "ignition.msgs.Actuators", "position: [7, 0.5] velocity: [1, 2]");
    } else {
      world.tellNumber(topic, 0.5);
    }
    world.step(4000);
    EXPECT_NEAR(angle(world), 0.5, 1e-3) << topic;
  }
}

TEST(JointPositionController, MovesFurtherJointsLikeTheFirst) {
  for (const char* way : {kGains, "<use_velocity_commands>1</use_velocity_commands>"}) {
    std::string text =
        worldWith("<joint_name>hinge2</joint_name><initial_position>0.5</initial_position>" + std::string(way));
    text.insert(text.find("<plugin"),
                "<link name='arm2'><inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz>"
                "</inertia></inertial></link><joint name='hinge2' type='revolute'><parent>base</parent>"
                "<child>arm2</child><axis><xyz>0 0 1</xyz></axis></joint>");
    RunningWorld world(text);
    world.step(4000);
    EXPECT_NEAR(angle(world), 0.5, 1e-3);
    EXPECT_NEAR(world.model("m").joint("hinge2")->position(), 0.5, 1e-3);
  }
}

TEST(JointPositionController, RefusesAbsurdPositionsAndGoesOn) {
  for (const char* way : {kGains, "<use_velocity_commands>true</use_velocity_commands>"}) {
    RunningWorld world(worldWith(way));
    world.tellAbsurdities(kTopic, "ignition.msgs.Double", "data: #");
    EXPECT_NEAR(angle(world), 0, 1e-9);
    world.tellNumber(kTopic, 1);
    world.step(3000);
    EXPECT_NEAR(angle(world), 1, 0.01);
  }
}

TEST(JointPositionController, RecoversFromTheLargestPositions) {
  for (const char* way : {kGains, "<use_velocity_commands>true</use_velocity_commands>"}) {
    RunningWorld world(worldWith(way));
    testing::internal::CaptureStderr();
    world.tellNumber(kTopic, 1e6);
    world.step(10);
    world.tellNumber(kTopic, 1);
    world.step(5000);
    EXPECT_NEAR(angle(world), 1, 0.01) << way;
    testing::internal::GetCapturedStderr();
  }
}

TEST(JointPositionController, IsLeftOutWithTheReason) {
  const std::string left = "joint-position-controller of m is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<joint_index>1</joint_index>")),
            std::vector<std::string>{left + "joint 'hinge' has no axis 1"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<p_gain>inf</p_gain>")),
            std::vector<std::string>{left + "<p_gain> must be a finite number"});
  std::string other = worldWith("");
  other.replace(other.find("<joint_name>hinge"), 17, "<joint_name>hold");
  EXPECT_EQ(RunningWorld::complaintsAbout(other),
            std::vector<std::string>{left + "<joint_name> 'hold' is a joint without an axis to drive"});
}

TEST(JointPositionController, OfFortressTestWorldSettles) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "test/joint_position_controller.sdf");
  world.tellNumber("/model/joint_position_controller_test/joint/j1/0/cmd_pos", 1);
  world.step(1000);
  EXPECT_NEAR(world.model("joint_position_controller_test").joint("j1")->position(), 1, 0.1);
}

}  // namespace
}  // namespace pongsim::joint_position_controller_test
