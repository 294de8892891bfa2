#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/battery.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::thruster_test {
namespace {

using test::RunningWorld;

constexpr const char* kTopic = "/model/sub/joint/shaft/cmd_thrust";
constexpr const char* kDirect =
    "<joint_name>shaft</joint_name><propeller_diameter>0.25</propeller_diameter><fluid_density>950</fluid_density>"
    "<thrust_coefficient>0.005</thrust_coefficient><velocity_control>true</velocity_control>";
const double kSpeedOf100 = std::sqrt(100 / (950 * 0.005 * std::pow(0.25, 4)));

/// Model "sub" of 100 kg with a propeller of 0.1 kg, whose "shaft" lies along x.
std::string worldWith(const std::string& parameters) {
  return "<gravity>0 0 0</gravity><model name='sub'><link name='body'><inertial><mass>100</mass>"
         "<inertia><ixx>30</ixx><iyy>30</iyy><izz>30</izz></inertia></inertial></link>"
         "<link name='propeller'><pose>-1 0 0 0 0 0</pose><inertial><mass>0.1</mass>"
         "<inertia><ixx>0.002</ixx><iyy>0.002</iyy><izz>0.002</izz></inertia></inertial></link>"
         "<joint name='shaft' type='revolute'><parent>body</parent><child>propeller</child>"
         "<axis><xyz>1 0 0</xyz></axis></joint>"
         "<plugin filename='ignition-gazebo-thruster-system' name='ignition::gazebo::systems::Thruster'>" +
         parameters + "</plugin></model>";
}

double speedOf(RunningWorld& world) { return world.model("sub").link("body")->linearVelocity().x(); }
double turningOf(RunningWorld& world) { return world.model("sub").joint("shaft")->velocity(); }

TEST(Thruster, PushesWithTheThrustThatItIsTold) {
  RunningWorld world(worldWith(kDirect));
  world.step(100);
  EXPECT_EQ(speedOf(world), 0);
  world.tellNumber(kTopic, 100);
  world.step(1000);
  EXPECT_NEAR(speedOf(world), 100 / 100.1, 1e-3);
  EXPECT_NEAR(turningOf(world), kSpeedOf100, 1e-3 * kSpeedOf100);
  world.tellNumber(kTopic, -100);
  world.step(1000);
  EXPECT_NEAR(speedOf(world), 0, 1e-3);
  EXPECT_NEAR(turningOf(world), -kSpeedOf100, 1e-3 * kSpeedOf100);
}

TEST(Thruster, ListensToTheTopicsOfItsNamespace) {
  for (const auto& [parameters, topic] : std::vector<std::pair<std::string, std::string>>{
           {"", "/model/sub/joint/shaft/cmd_pos"},
           {"<namespace>custom</namespace>", "/model/custom/joint/shaft/cmd_thrust"},
           {"<namespace>custom</namespace>", "/model/custom/joint/shaft/cmd_pos"},
           {"<topic>push</topic>", "/sub/push"},
           {"<namespace>custom</namespace><topic>push</topic>", "/custom/push"}}) {
    RunningWorld world(worldWith(kDirect + parameters));
    world.tellNumber(topic, 100);
    world.step(10);
    EXPECT_GT(speedOf(world), 0) << topic;
  }
}

// T = rho Kt D^4 n |n|
TEST(Thruster, PushesAsMuchAsTheSpeedThatItIsToldGives) {
  for (const auto& [parameters, topic, feedback] :
       std::vector<std::array<std::string, 3>>{{"", "/model/sub/joint/shaft/cmd_vel", "/model/sub/joint/shaft/force"},
                                               {"<topic>turn</topic>", "/sub/turn", "/sub/turn/force"}}) {
    RunningWorld world(worldWith(kDirect + parameters + "<use_angvel_cmd>true</use_angvel_cmd>"));
    std::vector<ignition::msgs::Double> forces;
    world.listen(feedback, forces);
    world.tellNumber(topic, -kSpeedOf100);
    world.step(1000);
    EXPECT_NEAR(speedOf(world), -100 / 100.1, 1e-3);
    EXPECT_NEAR(turningOf(world), -kSpeedOf100, 1e-3 * kSpeedOf100);
    ASSERT_EQ(forces.size(), 1000U);
    EXPECT_NEAR(forces.back().data(), -100, 1e-3);
  }
}

TEST(Thruster, TellsTheSpeedOfItsPropeller) {
  for (const auto& [parameters, topic] : std::vector<std::pair<std::string, std::string>>{
           {"", "/model/sub/joint/shaft/ang_vel"}, {"<topic>push</topic>", "/sub/push/ang_vel"}}) {
    RunningWorld world(worldWith(kDirect + parameters));
    std::vector<ignition::msgs::Double> speeds;
    world.listen(topic, speeds);
    world.tellNumber(parameters.empty() ? kTopic : "/sub/push", 100);
    world.step(10);
    ASSERT_EQ(speeds.size(), 10U);
    EXPECT_NEAR(speeds.back().data(), kSpeedOf100, 1e-6);
  }
}

TEST(Thruster, LeavesOutThrustsWithinTheDeadband) {
  RunningWorld world(worldWith(std::string(kDirect) + "<deadband>50</deadband>"));
  world.tellNumber(kTopic, 49);
  world.step(100);
  EXPECT_EQ(speedOf(world), 0);
  EXPECT_NEAR(turningOf(world), 0, 1e-9);
  world.tellText("/model/sub/joint/shaft/enable_deadband", "ignition.msgs.Boolean", "data: false");
  world.step(100);
  EXPECT_NEAR(speedOf(world), 49 / 100.1 * 0.1, 1e-4);
  world.tellText("/model/sub/joint/shaft/enable_deadband", "ignition.msgs.Boolean", "data: true");
  world.step(100);
  EXPECT_NEAR(speedOf(world), 49 / 100.1 * 0.1, 1e-4);
  world.tellNumber(kTopic, 50);
  world.step(100);
  EXPECT_NEAR(speedOf(world), 99 / 100.1 * 0.1, 1e-4);
}

TEST(Thruster, KeepsWithinItsLimits) {
  RunningWorld world(
      worldWith(std::string(kDirect) + "<max_thrust_cmd>30</max_thrust_cmd><min_thrust_cmd>-10</min_thrust_cmd>"));
  world.tellNumber(kTopic, 100);
  world.step(100);
  EXPECT_NEAR(speedOf(world), 30 / 100.1 * 0.1, 1e-4);
  world.tellNumber(kTopic, -100);
  world.step(300);
  EXPECT_NEAR(speedOf(world), 0, 1e-4);
}

// the torques of the controller on 0.002 kg m^2: the speed comes near the target by dw/dt = p / I (target - w)
TEST(Thruster, TurnsThePropellerByAController) {
  RunningWorld world(
      worldWith("<joint_name>shaft</joint_name><propeller_diameter>0.25</propeller_diameter><thrust_coefficient>0.005"
                "</thrust_coefficient><fluid_density>950</fluid_density><p_gain>0.01</p_gain>"));
  world.tellNumber(kTopic, 100);
  world.step(200);
  EXPECT_NEAR(turningOf(world), kSpeedOf100 * (1 - std::exp(-1)), 0.01 * kSpeedOf100);
  world.step(3000);
  EXPECT_NEAR(turningOf(world), kSpeedOf100, 0.2);
  EXPECT_NEAR(speedOf(world), 3.2 * 100 / 100.1, 1e-2);
}

// what the propeller turns at is what the thrust takes: T = rho n^2 D^4 Kt, Kt from the advance
TEST(Thruster, HasTheCoefficientOfItsAdvance) {
  RunningWorld world(
      worldWith("<joint_name>shaft</joint_name><propeller_diameter>0.2</propeller_diameter><alpha_1>0.9</alpha_1>"
                "<alpha_2>-0.3</alpha_2><wake_fraction>0.25</wake_fraction><velocity_control>true</velocity_control>"));
  world.tellNumber(kTopic, 50);
  world.step(2000);
  const double speed = turningOf(world);
  const double craft = world.model("sub").link("propeller")->linearVelocity().norm();
  const double coefficient = 0.9 - 0.3 * 0.75 * craft / (speed * 0.2);
  EXPECT_NEAR(1000 * speed * speed * std::pow(0.2, 4) * coefficient, 50, 0.5);
  EXPECT_GT(craft, 0.5);
}

TEST(Thruster, RefusesAbsurdThrustsAndGoesOn) {
  RunningWorld world(worldWith(kDirect));
  world.tellAbsurdities(kTopic, "ignition.msgs.Double", "data: #", "1e+08");
  EXPECT_EQ(speedOf(world), 0);
  world.tellNumber(kTopic, 100);
  world.step(100);
  EXPECT_NEAR(speedOf(world), 100 / 100.1 * 0.1, 1e-4);
}

TEST(Thruster, TakesItsPowerFromABatteryAndRestsWhenThatIsEmpty) {
  RunningWorld world(worldWith(std::string(kDirect) + "<power_load>50</power_load><battery_name>cell</battery_name>"));
  Batteries batteries(world.simulation().world());
  Outcome<Battery> cell = batteries.add(world.model("sub"), "cell", 1);
  ASSERT_TRUE(cell);
  world.tellNumber(kTopic, 100);
  world.step(10);
  EXPECT_EQ(cell->load(), 50);
  EXPECT_GT(speedOf(world), 0);
  cell->setCharge(0);
  const double speed = speedOf(world);
  world.step(10);
  EXPECT_NEAR(speedOf(world), speed, 1e-9);
}

TEST(Thruster, SaysThatItsBatteryIsNotThere) {
  RunningWorld world(worldWith(std::string(kDirect) + "<power_load>50</power_load><battery_name>cell</battery_name>"));
  testing::internal::CaptureStderr();
  world.step(10);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("draws no power from battery 'cell': there is none of that name"), std::string::npos) << said;
}

TEST(Thruster, GoesOnWithTheSameBitsFromASavedStateAndAfterAReset) {
  const std::string text =
      worldWith("<joint_name>shaft</joint_name><p_gain>0.01</p_gain><i_gain>0.1</i_gain><alpha_2>-0.1</alpha_2>");
  RunningWorld world(text);
  world.tellNumber(kTopic, 50);
  world.step(100);
  RunningWorld other(text);
  test::expectSameBitsFromSavedState(world, other, 100);

  test::resetWorld(other);
  other.step(100);
  EXPECT_EQ(speedOf(other), 0);
}

TEST(ThrusterParameters, AreWarnedOfWhereTheyMakeNoSense) {
  const std::string left = "thruster of sub is left out: ", joint = "<joint_name>shaft</joint_name>";
  for (const auto& [parameters, message] : std::vector<std::pair<std::string, std::string>>{
           {"", left + "no <joint_name> is given"},
           {"<joint_name>shft</joint_name>", left + "<joint_name> 'shft' is not a joint of model 'sub'"},
           {joint + "<propeller_diameter>0</propeller_diameter>", left + "<propeller_diameter> must be above zero"},
           {joint + "<propeller_diameter>-1</propeller_diameter>", left + "<propeller_diameter> must be above zero"},
           {joint + "<fluid_density>0</fluid_density>", left + "<fluid_density> must be above zero"},
           {joint + "<thrust_coefficient>0</thrust_coefficient>", left + "<thrust_coefficient> must not be zero"},
           {joint + "<power_load>5</power_load>", "<power_load> has no effect: no <battery_name> is given"},
           {joint + "<max_thrust_cmd>-2000</max_thrust_cmd>",
            "<max_thrust_cmd> is below <min_thrust_cmd>: 1000 and -1000 N are used"},
           {joint + "<thrust_coefficient>1</thrust_coefficient><alpha_1>1</alpha_1>",
            "<alpha_1> has no effect: <thrust_coefficient> is given too"}}) {
    EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(parameters)), std::vector{message});
  }
}

}  // namespace
}  // namespace pongsim::thruster_test
