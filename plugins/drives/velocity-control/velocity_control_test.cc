#include <gtest/gtest.h>
#include <ignition/msgs/twist.pb.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::velocity_control_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& parameters) {
  return R"(<gravity>0 0 0</gravity><model name="m"><pose>0 0 0 0 0 1.5707963267948966</pose>
    <link name="body"><inertial><mass>2</mass></inertial></link>
    <link name="wheel"><pose>1 0 0 0 0 0</pose><inertial><mass>2</mass></inertial></link>
    <joint name="axle" type="revolute"><parent>body</parent><child>wheel</child><axis><xyz>1 0 0</xyz></axis></joint>
    <plugin filename="ignition-gazebo-velocity-control-system" name="ignition::gazebo::systems::VelocityControl">)" +
         parameters + "</plugin></model>";
}

ignition::msgs::Twist twist(double forward, double turn) {
  ignition::msgs::Twist message;
  message.mutable_linear()->set_x(forward);
  message.mutable_angular()->set_z(turn);
  return message;
}

TEST(VelocityControl, MovesTheModelInItsOwnFrame) {
  RunningWorld world(worldWith(""));
  world.step(10);
  EXPECT_EQ(world.model("m").pose().position, Vector3::Zero());
  world.tell("/model/m/cmd_vel", twist(2, 0));
  world.step(500);
  const Pose pose = world.model("m").pose();
  EXPECT_NEAR((pose.position - Vector3(0, 1, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR((world.model("m").link("wheel")->pose().position - Vector3(0, 2, 0)).norm(), 0, 1e-6);
}

TEST(VelocityControl, DrivesInCircles) {
  RunningWorld world(worldWith("<initial_linear>1 0 0</initial_linear><initial_angular>0 0 1</initial_angular>"));
  world.step(3142);
  // half a circle of one metre's radius, to the left of where it looked
  const Pose pose = world.model("m").pose();
  EXPECT_NEAR((pose.position - Vector3(-2, 0, 0)).norm(), 0, 0.01);
  EXPECT_NEAR(std::abs(yawOf(pose.rotation)), std::acos(0.0), 0.01);
}

TEST(VelocityControl, MovesALinkOnceItIsTold) {
  RunningWorld world(worldWith("<topic>move</topic><link_name>wheel</link_name>"));
  world.step(10);
  world.tell("/move", twist(1, 0));
  world.step(10);
  EXPECT_NEAR(world.model("m").link("wheel")->linearVelocity().y(), 1, 1e-6);
  // its motion along the way is then the link's own, in place of the model's
  ignition::msgs::Twist turn = twist(1, 0);
  turn.mutable_angular()->set_x(5);
  world.tell("/model/m/link/wheel/cmd_vel", turn);
  world.step(10);
  EXPECT_NEAR(world.model("m").joint("axle")->velocity(), 5, 0.01);
  EXPECT_NEAR(world.model("m").link("body")->linearVelocity().y(), 1, 1e-3);
}

TEST(VelocityControl, RefusesAbsurdVelocitiesAndGoesOn) {
  RunningWorld world(worldWith("<link_name>wheel</link_name>"));
  world.tellAbsurdities("/model/m/cmd_vel", "ignition.msgs.Twist", "linear {x: #}");
  world.tellAbsurdities("/model/m/link/wheel/cmd_vel", "ignition.msgs.Twist", "linear {x: 1} angular {z: #}");
  EXPECT_EQ(world.model("m").pose().position, Vector3::Zero());
  world.tell("/model/m/cmd_vel", twist(2, 0));
  world.step(500);
  EXPECT_NEAR((world.model("m").pose().position - Vector3(0, 1, 0)).norm(), 0, 1e-6);
}

TEST(VelocityControl, IsLeftOutWithTheReason) {
  const std::string left = "velocity-control of m is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<link_name>leg</link_name>")),
            std::vector<std::string>{left + "<link_name> 'leg' is not a link of model 'm'"});
  EXPECT_EQ(RunningWorld::complaintsAbout("<model name='outer'>" + worldWith("").substr(24) + "</model>"),
            std::vector<std::string>{
                "velocity-control of outer::m is left out: VelocityControl only moves top-level models"});
}

TEST(VelocityControl, OfFortressTestWorldDrives) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "test/velocity_control.sdf");
  const Pose start = world.model("vehicle_blue").pose();
  world.tell("/model/vehicle_blue/cmd_vel", twist(0.5, 0.2));
  world.step(3000);
  const Pose end = world.model("vehicle_blue").pose();
  EXPECT_NEAR(std::remainder(yawOf(end.rotation) - yawOf(start.rotation), 2 * std::acos(-1)), 0.6, 0.02);
  // chord of the arc of 1.5 m
  EXPECT_NEAR((end.position - start.position).head<2>().norm(), 2 * 2.5 * std::sin(0.3), 0.02);
}

}  // namespace
}  // namespace pongsim::velocity_control_test
