#include <gtest/gtest.h>
#include <ignition/msgs/actuators.pb.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support/drone_world.hh"
#include "support/fortress_worlds.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::multicopter_velocity_control_test {
namespace {

using test::drone;
using test::kDroneMass;
using test::kDroneThrust;
using test::RunningWorld;

// between body and world
constexpr const char* kHold = "<joint name='hold' type='fixed'><parent>world</parent><child>body</child></joint>";

std::string control(const std::string& parameters = {}) {
  std::string text =
      "<plugin filename='ignition-gazebo-multicopter-control-system' "
      "name='ignition::gazebo::systems::MulticopterVelocityControl'><robotNamespace>d</robotNamespace>"
      "<comLinkName>body</comLinkName><velocityGain>2.7 2.7 2.7</velocityGain><attitudeGain>2 3 0.15</attitudeGain>"
      "<angularRateGain>0.4 0.52 0.18</angularRateGain>" +
      parameters + "<rotorConfiguration>";
  for (int i = 0; i < 4; ++i) {
    text += "<rotor><jointName>joint" + std::to_string(i) +
            "</jointName><forceConstant>8.54858e-06</forceConstant><momentConstant>0.016</momentConstant><direction>" +
            (i < 2 ? "1" : "-1") + "</direction></rotor>";
  }
  return text + "</rotorConfiguration></plugin>";
}

// what the controller does not know of
constexpr const char* kNoDrag =
    "<rotorDragCoefficient>0</rotorDragCoefficient><rollingMomentCoefficient>0</rollingMomentCoefficient>";

std::string flying(const std::string& parameters = {}) {
  return drone({.motor = kNoDrag, .rest = control(parameters)});
}

void command(RunningWorld& world, const Vector3& linear, double yawRate = 0) {
  ignition::msgs::Twist message;
  message.mutable_linear()->set_x(linear.x());
  message.mutable_linear()->set_y(linear.y());
  message.mutable_linear()->set_z(linear.z());
  message.mutable_angular()->set_z(yawRate);
  world.tell("/d/cmd_vel", message);
}

void setEnabled(RunningWorld& world, bool enabled) {
  ignition::msgs::Boolean message;
  message.set_data(enabled);
  world.tell("/d/enable", message);
}

/// @return Velocity in the axes of the body.
Vector3 velocityOf(RunningWorld& world) {
  const Link body = world.model("d").link("body").value();
  return body.pose().rotation.conjugate() * body.linearVelocity();
}

double fastestRotor(RunningWorld& world) { return std::ranges::max(*world.model("d").actuators()); }

TEST(MulticopterVelocityControl, FliesAsItIsTold) {
  RunningWorld world(flying("<maximumLinearAcceleration>2 2 2</maximumLinearAcceleration>"));
  for (const auto& [linear, yawRate] :
       {std::pair(Vector3(0, 0, 0.2), 0.0), {Vector3(0.1, 0, 0), 0.0}, {Vector3(0.1, -0.2, 0.2), 0.05}}) {
    command(world, linear, yawRate);
    world.step(4000);
    EXPECT_NEAR((velocityOf(world) - linear).norm(), 0, 1e-2) << linear.transpose();
    const Vector3 turn = world.model("d").link("body")->angularVelocity();
    EXPECT_NEAR((turn - Vector3(0, 0, yawRate)).norm(), 0, 1e-2) << linear.transpose();
  }
}

TEST(MulticopterVelocityControl, WaitsForTheFirstCommand) {
  RunningWorld world(flying());
  world.step(100);
  EXPECT_EQ(*world.model("d").actuators(), std::vector<double>(4, 0));
  command(world, {0, 0, 0});
  world.step(1);
  EXPECT_GT(fastestRotor(world), 600);
}

TEST(MulticopterVelocityControl, KeepsWithinItsLimits) {
  RunningWorld world(
      flying("<maximumLinearVelocity>9 9 -0.3</maximumLinearVelocity>"
             "<maximumAngularVelocity>0 0 0.1</maximumAngularVelocity>"));
  command(world, {0, 0, 50}, 5);
  world.step(4000);
  EXPECT_NEAR(velocityOf(world).z(), 0.3, 5e-3);
  EXPECT_NEAR(world.model("d").link("body")->angularVelocity().z(), 0.1, 5e-3);
  command(world, {0, 0, -50}, -5);
  world.step(4000);
  EXPECT_NEAR(velocityOf(world).z(), -0.3, 5e-3);
  EXPECT_NEAR(world.model("d").link("body")->angularVelocity().z(), -0.1, 5e-3);
}

TEST(MulticopterVelocityControl, AcceleratesNoMoreThanItMay) {
  RunningWorld world(flying("<maximumLinearAcceleration>1 1 0.5</maximumLinearAcceleration>"));
  command(world, {0, 0, 100});
  world.step(500);
  const double before = velocityOf(world).z();
  world.step(1000);
  EXPECT_NEAR(velocityOf(world).z() - before, 0.5, 1e-3);
}

TEST(MulticopterVelocityControl, StopsWhileItIsSwitchedOff) {
  RunningWorld world(flying());
  command(world, {0, 0, 0.5});
  world.step(100);
  setEnabled(world, false);
  world.step(100);
  EXPECT_EQ(*world.model("d").actuators(), std::vector<double>(4, 0));
  // the old command is forgotten
  setEnabled(world, true);
  world.step(100);
  EXPECT_EQ(*world.model("d").actuators(), std::vector<double>(4, 0));
  command(world, {0, 0, 0.5});
  world.step(1);
  EXPECT_GT(fastestRotor(world), 600);
}

TEST(MulticopterVelocityControl, ListensToTheTopicsThatTheWorldNames) {
  std::string text = flying("<commandSubTopic>go to</commandSubTopic><enableSubTopic>on/off</enableSubTopic>");
  const std::string old = "<robotNamespace>d<";
  RunningWorld world(text.replace(text.find(old), old.size(), "<robotNamespace>my drone<"));
  world.tell("/my_drone/go_to", ignition::msgs::Twist());
  world.step(1);
  EXPECT_GT(fastestRotor(world), 600);
  world.tell("/my_drone/on/off", ignition::msgs::Boolean());
  world.step(1);
  EXPECT_EQ(fastestRotor(world), 0);
}

/// What was measured of a body that does not move, made from what the rotors were told.
struct Statistics {
  double mean = 0;
  double deviation = 0;
};

template <class Read>
Statistics statisticsOf(RunningWorld& world, Read read) {
  constexpr int kCount = 4000;
  double sum = 0, squares = 0;
  for (int i = 0; i < kCount; ++i) {
    world.step(1);
    const std::vector<double>& speeds = *world.model("d").actuators();
    const double value = read(speeds);
    sum += value;
    squares += value * value;
  }
  return {sum / kCount, std::sqrt(squares / kCount - sum * sum / kCount / kCount)};
}

TEST(MulticopterVelocityControl, MeasuresVelocityWithNoise) {
  RunningWorld world(
      drone({.rest = kHold + control("<linearVelocityNoiseMean>7 7 0.2</linearVelocityNoiseMean>"
                                     "<linearVelocityNoiseStdDev>0 0 0.1</linearVelocityNoiseStdDev>")}));
  command(world, {0, 0, 0});
  // thrust = m g - gain * velocity
  const Statistics found = statisticsOf(world, [](const std::vector<double>& speeds) {
    double thrust = 0;
    for (const double speed : speeds) thrust += kDroneThrust * speed * speed;
    return (kDroneMass * 9.8 - thrust) / 2.7;
  });
  // four times what a mean and a deviation of 4000 are uncertain by
  EXPECT_NEAR(found.mean, 0.2, 4 * 0.1 / std::sqrt(4000));
  EXPECT_NEAR(found.deviation, 0.1, 4 * 0.1 / std::sqrt(8000));
}

TEST(MulticopterVelocityControl, MeasuresAngularVelocityWithNoise) {
  RunningWorld world(
      drone({.rest = kHold + control("<angularVelocityNoiseMean>0 0 -0.1</angularVelocityNoiseMean>"
                                     "<angularVelocityNoiseStdDev>0 0 0.05</angularVelocityNoiseStdDev>")}));
  command(world, {0, 0, 0});
  // torque = -gain * angular velocity
  const Statistics found = statisticsOf(world, [](const std::vector<double>& speeds) {
    double torque = 0;
    for (std::size_t i = 0; i < 4; ++i) torque -= (i < 2 ? 1 : -1) * kDroneThrust * 0.016 * speeds[i] * speeds[i];
    return -torque / 0.18;
  });
  EXPECT_NEAR(found.mean, -0.1, 4 * 0.05 / std::sqrt(4000));
  EXPECT_NEAR(found.deviation, 0.05, 4 * 0.05 / std::sqrt(8000));
}

TEST(MulticopterVelocityControl, CarriesWhatTheModelHolds) {
  const std::string load =
      "<model name='load'><pose>0 0 -0.2 0 0 0</pose><link name='box'><inertial><mass>0.5</mass><inertia>"
      "<ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz></inertia></inertial></link></model>"
      "<joint name='strap' type='fixed'><parent>body</parent><child>load::box</child></joint>";
  RunningWorld world(drone({.rest = load + control()}));
  command(world, {0, 0, 0.3});
  world.step(4000);
  EXPECT_NEAR(velocityOf(world).z(), 0.3, 1e-2);
}

// The loads would collide if they did not belong to what they are strapped to.
TEST(MulticopterVelocityControl, CarriesLoadsThatOverlap) {
  std::string loads;
  for (const std::string name : {"hook", "box"}) {
    loads += "<model name='" + name +
             "'><link name='l'><inertial><mass>0.2</mass><inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz>"
             "</inertia></inertial><collision name='c'><geometry><box><size>0.1 0.1 0.1</size></box></geometry>"
             "</collision></link></model><joint name='strap_" +
             name + "' type='fixed'><parent>body</parent><child>" + name + "::l</child></joint>";
  }
  RunningWorld world(drone({.motor = kNoDrag, .rest = loads + control()}));
  command(world, {0.3, 0, 0.2});
  world.step(5000);
  EXPECT_NEAR(velocityOf(world).x(), 0.3, 2e-2);
  EXPECT_NEAR(velocityOf(world).z(), 0.2, 1e-2);
}

TEST(MulticopterVelocityControl, IgnoresCommandsThatMakeNoSense) {
  RunningWorld world(flying());
  command(world, {0, 0, 0.2});
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {infinity, -infinity, std::nan(""), 1e308, -1e308}) {
    command(world, {0, 0, value});
    command(world, {0, 0, 0}, value);
  }
  world.step(4000);
  EXPECT_NEAR(velocityOf(world).z(), 0.2, 1e-2);
}

TEST(MulticopterVelocityControl, StartsAnewAfterAReset) {
  RunningWorld world(flying("<linearVelocityNoiseStdDev>0.01 0.01 0.01</linearVelocityNoiseStdDev>"));
  command(world, {0.1, 0, 0.2}, 0.1);
  world.step(500);
  const std::uint64_t hash = world.simulation().stateHash();
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  world.step(10);
  EXPECT_EQ(*world.model("d").actuators(), std::vector<double>(4, 0));
  world.simulation().reset(diagnostics);
  command(world, {0.1, 0, 0.2}, 0.1);
  world.step(500);
  EXPECT_EQ(world.simulation().stateHash(), hash);
}

TEST(MulticopterVelocityControl, GoesOnFromASavedState) {
  const std::string text = flying("<linearVelocityNoiseStdDev>0.01 0.01 0.01</linearVelocityNoiseStdDev>");
  RunningWorld world(text);
  command(world, {0.1, 0, 0.2}, 0.1);
  world.step(200);
  RunningWorld other(text);
  test::expectSameBitsFromSavedState(world, other, 200);
}

TEST(MulticopterVelocityControl, SaysWhatIsWrongWithIt) {
  const auto complaint = [](const std::string& from, const std::string& to) {
    std::string text = control("<maximumLinearAcceleration>2 2 2</maximumLinearAcceleration>");
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    const auto complaints = RunningWorld::complaintsAbout(drone({.rest = text.replace(at, from.size(), to)}));
    return complaints.size() == 1 ? complaints[0] : std::to_string(complaints.size()) + " complaints";
  };
  const std::string left = "multicopter-control of d is left out: ";
  const std::array<std::array<std::string, 3>, 7> cases{{
      {"<robotNamespace>d</robotNamespace>", "", left + "no <robotNamespace> is given"},
      {"<comLinkName>body", "<comLinkName>trunk", left + "<comLinkName> 'trunk' is not a link of model 'd'"},
      {"<velocityGain>2.7 2.7 2.7", "<velocityGain>2.7 2.7",
       left + "<velocityGain> is '2.7 2.7', which is not three numbers"},
      {"<attitudeGain>2 3 0.15</attitudeGain>", "", left + "no <attitudeGain> is given"},
      {"<maximumLinearAcceleration>2 2 2", "<maximumLinearAcceleration>2 2 -2",
       left + "<maximumLinearAcceleration> must be three numbers, zero or more"},
      {"<jointName>joint3", "<jointName>joint7", left + "<jointName> 'joint7' is not a joint of model 'd'"},
      {"<direction>-1", "<direction>0", left + "<direction> is 0"},
  }};
  for (const auto& [from, to, expected] : cases) EXPECT_EQ(complaint(from, to), expected);

  // without one of its rotors
  std::string text = control();
  const std::size_t end = text.find("</rotor>") + 8;
  text.erase(text.find("<rotor>"), end - text.find("<rotor>"));
  const auto complaints = RunningWorld::complaintsAbout(drone({.rest = text}));
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_EQ(complaints[0], left +
                               "3 rotors like these can't control a body: of thrust and three torques, they can set "
                               "only 3 independently");
}

// As Fortress's test of the same name.
TEST(MulticopterVelocityControl, ModelAndVelocityControlInteraction) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "Fortress's worlds are not here";
  RunningWorld world(*worlds / "test/quadcopter_velocity_control.sdf");
  world.step(1);
  world.tell("/X3/gazebo/command/twist", ignition::msgs::Twist());
  world.step(200);
  ignition::msgs::Actuators message;
  for (int i = 0; i < 4; ++i) message.add_velocity(60);
  world.tell("/X3/gazebo/command/motor_speed", message);
  world.step(10);
  for (const Joint& joint : world.model("X3").joints()) EXPECT_NEAR(std::abs(joint.velocity()), 650, 50);
}

}  // namespace
}  // namespace pongsim::multicopter_velocity_control_test
