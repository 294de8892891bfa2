#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "support/running_world.hh"

// A quadcopter of the kind of PX4's x500: rotors that weigh next to nothing, in steps of 4 ms.
namespace pongsim::quadcopter_test {
namespace {

using test::RunningWorld;

constexpr double kThrust = 8.5e-6;
constexpr double kRotorMass = 0.016;
constexpr double kMass = 2 + 4 * kRotorMass;
const double kHover = std::sqrt(kMass * 9.8 / 4 / kThrust);

std::string quadcopter(const std::string& motor = "") {
  std::string text =
      "<physics name='p' type='ode'><max_step_size>0.004</max_step_size></physics><model name='ground'>"
      "<static>true</static><link name='l'><collision name='c'><geometry><plane/></geometry></collision></link></model>"
      "<model name='quad'><pose>0 0 0.24 0 0 0</pose><link "
      "name='body'><inertial><mass>2</mass><inertia><ixx>0.022</ixx>"
      "<iyy>0.022</iyy><izz>0.04</izz></inertia></inertial><collision name='c'><pose>0 0 -0.2 0 0 "
      "0</pose><geometry><box>"
      "<size>0.3 0.3 0.05</size></box></geometry></collision></link>";
  // the first two turn anticlockwise, at opposite corners
  constexpr std::array<std::pair<double, double>, 4> kPlaces{
      {{0.17, -0.17}, {-0.17, 0.17}, {0.17, 0.17}, {-0.17, -0.17}}};
  for (std::size_t i = 0; i < kPlaces.size(); ++i) {
    const std::string number = std::to_string(i);
    text += "<link name='rotor_" + number + "'><pose>" + std::to_string(kPlaces[i].first) + " " +
            std::to_string(kPlaces[i].second) +
            " 0.06 0 0 0</pose><inertial><mass>0.016</mass><inertia><ixx>4e-7</ixx><iyy>2.6e-5</iyy><izz>2.63e-5</izz>"
            "</inertia></inertial></link><joint name='rotor_" +
            number + "_joint' type='revolute'><parent>body</parent><child>rotor_" + number +
            "</child><axis><xyz>0 0 1</xyz><limit><lower>-1e16</lower><upper>1e16</upper></limit></axis></joint>"
            "<plugin filename='gz-sim-multicopter-motor-model-system' name='gz::sim::systems::MulticopterMotorModel'>"
            "<jointName>rotor_" +
            number + "_joint</jointName><linkName>rotor_" + number + "</linkName><actuator_number>" + number +
            "</actuator_number><turningDirection>" + (i < 2 ? "ccw" : "cw") +
            "</turningDirection><maxRotVelocity>1000</maxRotVelocity><motorConstant>8.5e-06</motorConstant>"
            "<commandSubTopic>command/motor_speed</commandSubTopic><motorType>velocity</motorType>" +
            motor + "</plugin>";
  }
  return text + "</model>";
}

void command(RunningWorld& world, double first, double second) {
  const std::string a = std::to_string(first), b = std::to_string(second);
  world.tellText("/quad/command/motor_speed", "ignition.msgs.Actuators",
                 "velocity: [" + a + ", " + a + ", " + b + ", " + b + "]");
}

TEST(Quadcopter, TakesOffAndHoldsItsVelocityWhereItsThrustIsItsWeight) {
  RunningWorld world(quadcopter());
  const Link body = world.model("quad").link("body").value();
  world.step(250);
  EXPECT_LT(body.linearVelocity().norm(), 1e-3);
  command(world, 1.05 * kHover, 1.05 * kHover);
  world.step(500);
  // (1.05^2 - 1) g for 2 s, less the time that the rotors need
  EXPECT_NEAR(body.linearVelocity().z(), 0.1025 * 9.8 * 2, 0.1);
  command(world, kHover, kHover);
  world.step(250);
  const Pose before = body.pose();
  const Vector3 velocity = body.linearVelocity();
  world.step(1000);
  EXPECT_NEAR((body.linearVelocity() - velocity).norm(), 0, 1e-3);
  EXPECT_NEAR((body.pose().position - before.position - 4 * velocity).norm(), 0, 1e-2);
  EXPECT_NEAR(body.pose().rotation.angularDistance(Quaternion::Identity()), 0, 1e-4);
}

// two of the same direction faster: it turns against them, 2 c k (w1^2 - w2^2) / I
TEST(Quadcopter, TurnsAgainstItsFasterRotors) {
  // their drag would brake the turning
  RunningWorld world(quadcopter("<rotorDragCoefficient>0</rotorDragCoefficient>"));
  const Link body = world.model("quad").link("body").value();
  const double faster = 1.1 * kHover, slower = std::sqrt(2 * kHover * kHover - faster * faster);
  command(world, 1.05 * kHover, 1.05 * kHover);
  world.step(250);
  command(world, faster, slower);
  world.step(50);
  const double before = body.angularVelocity().z();
  world.step(50);
  const double inertia = 0.04 + 4 * kRotorMass * 2 * 0.17 * 0.17;
  const double expected = -2 * 0.016 * kThrust * (faster * faster - slower * slower) / inertia;
  EXPECT_NEAR((body.angularVelocity().z() - before) / 0.2, expected, 0.05 * std::abs(expected));
  EXPECT_NEAR(body.angularVelocity().head<2>().norm(), 0, 1e-4);
}

}  // namespace
}  // namespace pongsim::quadcopter_test
