#include <gtest/gtest.h>
#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::ackermann_steering_test {
namespace {

using test::RunningWorld;

ignition::msgs::Twist twist(double linear, double angular) {
  ignition::msgs::Twist message;
  message.mutable_linear()->set_x(linear);
  message.mutable_angular()->set_z(angular);
  return message;
}

/// Model "m" with the joints "left" and "right", which turn links of 0.1 kg m^2 about z, and no wheels.
std::string steeringWith(const std::string& parameters) {
  std::string text = "<gravity>0 0 0</gravity><model name='m'>";
  for (const std::string side : {"left", "right"}) {
    text += "<link name='" + side +
            "_hub'><inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>"
            "</link><joint name='" +
            side + "' type='revolute'><parent>world</parent><child>" + side +
            "_hub</child><axis><xyz>0 0 1</xyz></axis></joint>";
  }
  return text +
         "<plugin filename='gz-sim-ackermann-steering-system' name='gz::sim::systems::AckermannSteering'>"
         "<left_steering_joint>left</left_steering_joint><right_steering_joint>right</right_steering_joint>"
         "<wheel_separation>1</wheel_separation><wheel_base>2</wheel_base>" +
         parameters + "</plugin></model>";
}

RunningWorld exampleWorld() {
  return RunningWorld(test::projectFolder() / "plugins/drives/ackermann-steering/ackermann_steering.sdf");
}

double speed(RunningWorld& world, const char* joint) { return world.model("car").joint(joint)->velocity(); }
double angle(RunningWorld& world, const char* joint) { return world.model("car").joint(joint)->position(); }

TEST(AckermannSteering, DrivesStraight) {
  RunningWorld world = exampleWorld();
  world.tell("/model/car/cmd_vel", twist(0.6, 0));
  world.step(2000);
  EXPECT_NEAR(speed(world, "rear_left_joint"), 2, 0.05);
  EXPECT_NEAR(world.model("car").pose().position.y(), 0, 0.05);
  EXPECT_GT(world.model("car").pose().position.x(), 0.7);
}

TEST(AckermannSteering, SteersTheInnerWheelMore) {
  RunningWorld world = exampleWorld();
  world.tell("/model/car/cmd_vel", twist(0.6, 0.3));
  world.step(6000);
  // a circle of 2 m
  EXPECT_NEAR(angle(world, "front_left_steering"), std::atan(1 / (2 - 0.4)), 0.04);
  EXPECT_NEAR(angle(world, "front_right_steering"), std::atan(1 / (2 + 0.4)), 0.04);
  EXPECT_GT(speed(world, "rear_right_joint"), speed(world, "rear_left_joint"));
  EXPECT_GT(yawOf(world.model("car").pose().rotation), 0.5);
}

TEST(AckermannSteering, KeepsWithinItsLimits) {
  RunningWorld world = exampleWorld();
  world.tell("/model/car/cmd_vel", twist(50, 0));
  world.step(1000);
  // 1 m/s^2 for a second, wheels of 0.3 m
  EXPECT_NEAR(speed(world, "rear_left_joint"), 1 / 0.3, 0.1);
  world.step(4000);
  EXPECT_NEAR(speed(world, "rear_left_joint"), 2 / 0.3, 0.1);
}

TEST(AckermannSteering, PublishesOdometryThatAgreesWithTheTruth) {
  RunningWorld world = exampleWorld();
  std::vector<ignition::msgs::Odometry> odometry;
  std::vector<ignition::msgs::Pose_V> tf;
  world.listen("/model/car/odometry", odometry);
  world.listen("/model/car/tf", tf);
  const Pose start = world.model("car").pose();
  world.tell("/model/car/cmd_vel", twist(0.5, 0.1));
  world.step(3000);
  ASSERT_EQ(odometry.size(), 150U);
  ASSERT_EQ(tf.size(), 150U);
  const Pose moved = start.inverse() * world.model("car").pose();
  // it counts with the yaw at the end of each step and slips a little
  EXPECT_NEAR(odometry.back().pose().position().x(), moved.position.x(), 0.1);
  EXPECT_NEAR(odometry.back().pose().position().y(), moved.position.y(), 0.1);
  EXPECT_EQ(odometry.back().header().data(0).value(0), "car/odom");
  EXPECT_EQ(odometry.back().header().data(1).value(0), "car/body");
  EXPECT_NEAR(odometry.back().twist().linear().x(), 0.5, 0.02);
}

TEST(AckermannSteering, OnlySteersIfItIsTold) {
  for (const auto& [parameters, topic] : std::vector<std::pair<std::string, std::string>>{
           {"<steering_only>1</steering_only>", "/model/m/steer_angle"},
           {"<steering_only>1</steering_only><sub_topic>wheel</sub_topic>", "/model/m/wheel"},
           {"<steering_only>1</steering_only><topic>turn</topic><sub_topic>wheel</sub_topic>", "/turn"},
           {"<use_actuator_msg>1</use_actuator_msg><actuator_number>1</actuator_number>", "/actuators"}}) {
    RunningWorld world(steeringWith(parameters + "<steer_p_gain>5</steer_p_gain>"));
    if (topic == "/actuators") {
      world.tellText(topic, "ignition.msgs.Actuators", "position: [9, 0.3]");
    } else {
      world.tellNumber(topic, 0.3);
    }
    // after 1 / gain, an e-th of the way is left: x' = 5 / s (goal - x)
    world.step(200);
    const double left = std::atan(4 * std::sin(0.3) / (4 * std::cos(0.3) - std::sin(0.3)));
    const double right = std::atan(4 * std::sin(0.3) / (4 * std::cos(0.3) + std::sin(0.3)));
    const Model model = world.model("m");
    EXPECT_NEAR(model.joint("left")->position(), left * (1 - std::exp(-1)), 2e-3) << topic;
    EXPECT_NEAR(model.joint("right")->position(), right * (1 - std::exp(-1)), 2e-3) << topic;
    world.step(3000);
    EXPECT_NEAR(model.joint("left")->position(), left, 1e-5) << topic;
    EXPECT_NEAR(model.joint("right")->position(), right, 1e-5) << topic;
  }
}

TEST(AckermannSteering, SteersNoFartherThanItCan) {
  RunningWorld world(steeringWith("<steering_only>1</steering_only><steering_limit>0.2</steering_limit>"));
  world.tellAbsurdities("/model/m/steer_angle", "ignition.msgs.Double", "data: #");
  world.tellNumber("/model/m/steer_angle", -1e6);
  world.step(20000);
  EXPECT_NEAR(world.model("m").joint("left")->position(),
              std::atan(-4 * std::sin(0.2) / (4 * std::cos(0.2) + std::sin(0.2))), 1e-5);
}

TEST(AckermannSteering, RefusesAbsurdCommandsAndGoesOn) {
  for (const char* text : {"linear {x: #}", "linear {x: 1} angular {z: #}"}) {
    RunningWorld world = exampleWorld();
    world.tellAbsurdities("/model/car/cmd_vel", "ignition.msgs.Twist", text);
    EXPECT_NEAR(speed(world, "rear_left_joint"), 0, 0.05);
    world.tell("/model/car/cmd_vel", twist(0.6, 0));
    world.step(2000);
    EXPECT_NEAR(speed(world, "rear_left_joint"), 2, 0.05);
  }
}

TEST(AckermannSteering, RecoversFromTheLargestAndTheSmallestCommands) {
  for (const char* text :
       {"linear {x: 1e6}", "linear {x: 1} angular {z: 1e6}", "linear {x: 1e6} angular {z: 1e-310}"}) {
    RunningWorld world = exampleWorld();
    testing::internal::CaptureStderr();
    world.tellText("/model/car/cmd_vel", "ignition.msgs.Twist", text);
    world.step(100);
    world.tell("/model/car/cmd_vel", twist(0.6, 0));
    world.step(4000);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << text;
    EXPECT_NEAR(speed(world, "rear_left_joint"), 2, 0.05) << text;
    EXPECT_TRUE(world.model("car").pose().position.allFinite()) << text;
  }
}

TEST(AckermannSteering, NamesEachParameterThatIsMissing) {
  EXPECT_EQ(RunningWorld::complaintsAbout(R"(<model name="m"><link name="l"/><plugin
      filename="ignition-gazebo-ackermann-steering-system" name="ignition::gazebo::systems::AckermannSteering">
      <left_joint>a</left_joint><wheel_base>-1</wheel_base></plugin></model>)"),
            (std::vector<std::string>{"ackermann-steering of m is left out: no <left_steering_joint> is given",
                                      "ackermann-steering of m is left out: no <right_steering_joint> is given",
                                      "ackermann-steering of m is left out: <wheel_base> must be above zero"}));
  EXPECT_EQ(RunningWorld::complaintsAbout(steeringWith("<steering_only>0</steering_only>")),
            std::vector<std::string>{"ackermann-steering of m is left out: no <left_joint> is given"});
  EXPECT_EQ(RunningWorld::complaintsAbout(steeringWith("<steering_only>1</steering_only>"
                                                       "<use_actuator_msg>1</use_actuator_msg>")),
            std::vector<std::string>{"<use_actuator_msg> has no effect: no <actuator_number> is given"});
}

TEST(AckermannSteering, OfFortressExampleDrivesACurve) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "examples/ackermann_steering.sdf");
  const Pose start = world.model("vehicle_blue").pose();
  world.tell("/model/vehicle_blue/cmd_vel", twist(0.5, 0.05));
  world.step(5000);
  const Pose moved = start.inverse() * world.model("vehicle_blue").pose();
  EXPECT_GT(moved.position.x(), 1);
  EXPECT_GT(yawOf(moved.rotation), 0.02);
}

}  // namespace
}  // namespace pongsim::ackermann_steering_test
