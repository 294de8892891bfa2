#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::joint_controller_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& parameters) {
  return test::hingeWith("joint-controller", "JointController", parameters);
}

constexpr const char* kJoint = "<joint_name>hinge</joint_name>";
constexpr const char* kTopic = "/model/m/joint/hinge/cmd_vel";

double velocity(RunningWorld& world) { return world.model("m").joint("hinge")->velocity(); }

TEST(JointController, TurnsAtTheVelocityItIsTold) {
  RunningWorld world(worldWith(std::string(kJoint) + "<initial_velocity>2</initial_velocity>"));
  world.step(10);
  EXPECT_NEAR(velocity(world), 2, 1e-6);
  world.tellNumber(kTopic, -3);
  world.step(10);
  EXPECT_NEAR(velocity(world), -3, 1e-6);
}

TEST(JointController, PushesTowardsTheVelocityIfItIsTold) {
  RunningWorld world(worldWith(std::string(kJoint) +
                               "<use_force_commands>true</use_force_commands><p_gain>0.2</p_gain><topic>cmd</topic>"));
  world.tellNumber("/cmd", 4);
  world.step(2);
  // 0.8 N m on 0.1 kg m^2 for two steps
  EXPECT_NEAR(velocity(world), 0.016, 1e-4);
  world.step(5000);
  EXPECT_NEAR(velocity(world), 4, 1e-3);
}

/// Content with a second hinge, "hinge2", of half the inertia.
std::string twoHingesWith(const std::string& parameters) {
  std::string text = worldWith(std::string(kJoint) + "<joint_name>hinge2</joint_name>" + parameters);
  return text.insert(
      text.find("<plugin"),
      "<link name='arm2'><inertial><mass>1</mass><inertia><ixx>0.05</ixx><iyy>0.05</iyy><izz>0.05</izz></inertia>"
      "</inertial></link><joint name='hinge2' type='revolute'><parent>base</parent><child>arm2</child>"
      "<axis><xyz>0 0 1</xyz></axis></joint>");
}

TEST(JointController, DrivesFurtherJointsLikeTheFirst) {
  RunningWorld turned(twoHingesWith("<initial_velocity>2</initial_velocity>"));
  turned.step(10);
  EXPECT_NEAR(velocity(turned), 2, 1e-6);
  EXPECT_NEAR(turned.model("m").joint("hinge2")->velocity(), 2, 1e-6);
  // 0.2 N m on both
  RunningWorld pushed(
      twoHingesWith("<use_force_commands>1</use_force_commands><cmd_max>0.2</cmd_max>"
                    "<initial_velocity>9</initial_velocity>"));
  pushed.step(100);
  EXPECT_NEAR(velocity(pushed), 0.2, 1e-3);
  EXPECT_NEAR(pushed.model("m").joint("hinge2")->velocity(), 0.4, 1e-3);
}

TEST(JointController, ListensToTheTopicOrTheActuatorThatItIsTold) {
  for (const auto& [parameters, topic] : std::vector<std::pair<std::string, std::string>>{
           {"<sub_topic>motor</sub_topic>", "/model/m/motor"},
           {"<sub_topic>motor</sub_topic><topic>wheel</topic>", "/wheel"},
           {"<use_actuator_msg>1</use_actuator_msg><actuator_number>2</actuator_number>", "/actuators"},
           {"<use_actuator_msg>1</use_actuator_msg><actuator_number>2</actuator_number><sub_topic>motors</sub_topic>",
            "/model/m/motors"}}) {
    RunningWorld world(worldWith(kJoint + parameters));
    if (parameters.find("actuator") != std::string::npos) {
      world.tellText(topic, "ignition.msgs.Actuators", "velocity: [7, 8, -3] position: [1, 2, 3]");
    } else {
      world.tellNumber(topic, -3);
    }
    world.step(10);
    EXPECT_NEAR(velocity(world), -3, 1e-6) << topic;
  }
}

TEST(JointController, GoesOnAfterAShortOrAbsurdMessageToItsActuator) {
  RunningWorld world(
      worldWith(std::string(kJoint) + "<use_actuator_msg>1</use_actuator_msg><actuator_number>2</actuator_number>"));
  world.tellAbsurdities("/actuators", "ignition.msgs.Actuators", "velocity: [0, 0, #]");
  world.tellText("/actuators", "ignition.msgs.Actuators", "velocity: [7, 8, 3]");
  testing::internal::CaptureStderr();
  for (int i = 0; i < 3; ++i) world.tellText("/actuators", "ignition.msgs.Actuators", "velocity: [7, 8]");
  world.step(10);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("a command of 2 actuators has no value for actuator 2 and was ignored"), std::string::npos);
  EXPECT_EQ(said.find("ignored"), said.rfind("ignored"));
  EXPECT_NEAR(velocity(world), 3, 1e-6);
}

TEST(JointController, LetsAFasterJointRunFreeIfItIsTold) {
  RunningWorld world(worldWith(std::string(kJoint) +
                               "<use_force_commands>1</use_force_commands><disable_braking>1</disable_braking>"));
  world.tellNumber(kTopic, 4);
  world.step(5000);
  EXPECT_NEAR(velocity(world), 4, 1e-3);
  for (const double slower : {1.0, 0.0, -1.0}) {
    world.tellNumber(kTopic, slower);
    world.step(1000);
    // it is driven back only where the command has the other sign
    if (slower < 0) {
      EXPECT_LT(velocity(world), 3);
    } else {
      EXPECT_NEAR(velocity(world), 4, 2e-3);
    }
  }
}

TEST(JointController, RefusesAbsurdVelocitiesAndGoesOn) {
  for (const char* way : {"", "<use_force_commands>true</use_force_commands>"}) {
    RunningWorld world(worldWith(std::string(kJoint) + way));
    world.tellAbsurdities(kTopic, "ignition.msgs.Double", "data: #");
    EXPECT_NEAR(velocity(world), 0, 1e-9);
    world.tellNumber(kTopic, -3);
    world.step(1000);
    EXPECT_NEAR(velocity(world), -3, 1e-3);
  }
}

TEST(JointController, IsLeftOutWithTheReason) {
  const std::string left = "joint-controller of m is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("")), std::vector<std::string>{left + "no <joint_name> is given"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<joint_name>knee</joint_name>")),
            std::vector<std::string>{left + "<joint_name> 'knee' is not a joint of model 'm'"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(std::string(kJoint) + "<actuator_number>-1</actuator_number>")),
            std::vector<std::string>{left + "<actuator_number> must be zero or more"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(std::string(kJoint) + "<use_actuator_msg>1</use_actuator_msg>")),
            std::vector<std::string>{"<use_actuator_msg> has no effect: no <actuator_number> is given"});
}

}  // namespace
}  // namespace pongsim::joint_controller_test
