#include <gtest/gtest.h>

#include <string>
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
}

}  // namespace
}  // namespace pongsim::joint_controller_test
