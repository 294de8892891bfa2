#include <gtest/gtest.h>
#include <ignition/msgs/actuators.pb.h>
#include <ignition/msgs/double.pb.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support/drone_world.hh"
#include "support/fortress_worlds.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::multicopter_motor_model_test {
namespace {

using test::drone;
using test::kDroneMass;
using test::kDroneThrust;
using test::RunningWorld;

constexpr const char* kWeightless = "<gravity>0 0 0</gravity>";
// rotors as they are by default
constexpr double kDrag = 1e-4, kRolling = 1e-6, kMoment = 0.016, kSlowdown = 10;

ignition::msgs::Actuators speeds(const std::vector<double>& values) {
  ignition::msgs::Actuators message;
  for (const double value : values) message.add_velocity(value);
  return message;
}

void command(RunningWorld& world, const std::vector<double>& values) { world.tell("/d/motor_speed", speeds(values)); }

/// @return Speed of a rotor [rad/s], as the joint turns.
double speedOf(RunningWorld& world, int number) {
  return world.model("d").joint("joint" + std::to_string(number))->velocity() * kSlowdown;
}

Vector3 velocityOf(RunningWorld& world) { return world.model("d").link("body")->linearVelocity(); }

TEST(MulticopterMotorModel, HoversWhereTheThrustIsTheWeight) {
  RunningWorld world(drone({}));
  const double speed = std::sqrt(kDroneMass * 9.8 / (4 * kDroneThrust));
  command(world, {speed, speed, speed, speed});
  world.step(500);
  const Vector3 before = velocityOf(world);
  world.step(1000);
  EXPECT_NEAR((velocityOf(world) - before).norm(), 0, 1e-6);
  EXPECT_NEAR(world.model("d").link("body")->angularVelocity().norm(), 0, 1e-6);
}

TEST(MulticopterMotorModel, ClimbsByWhatTheThrustHasMore) {
  RunningWorld world(drone({}));
  command(world, {700, 700, 700, 700});
  world.step(500);
  const Vector3 before = velocityOf(world);
  world.step(1000);
  const double expected = 4 * kDroneThrust * 700 * 700 / kDroneMass - 9.8;
  EXPECT_NEAR((velocityOf(world) - before - Vector3(0, 0, expected)).norm(), 0, 1e-5);
}

TEST(MulticopterMotorModel, TurnsAgainstTheRotors) {
  // their drag would brake the turning
  RunningWorld world(kWeightless + drone({.motor = "<rotorDragCoefficient>0</rotorDragCoefficient>"}));
  command(world, {700, 700, 0, 0});
  world.step(500);
  const Vector3 before = world.model("d").link("body")->angularVelocity();
  world.step(200);
  // the rotors turn evenly against the body, so that they turn with it
  double inertia = 0.098;
  for (const auto& [x, y] : test::kDroneRotors) inertia += 8e-5 + 0.005 * (x * x + y * y);
  const double expected = -2 * kDroneThrust * 700 * 700 * kMoment / inertia * 0.2;
  const Vector3 change = world.model("d").link("body")->angularVelocity() - before;
  EXPECT_NEAR(change.z(), expected, 2e-3 * std::abs(expected));
  EXPECT_NEAR(change.head<2>().norm(), 0, 1e-6);
}

// what the world has to hold it with is what the air does to it
TEST(MulticopterMotorModel, FeelsTheWind) {
  RunningWorld world(
      "<wind><linear_velocity>3 4 9</linear_velocity></wind>" +
      drone({.rest = "<joint name='hold' type='fixed'><parent>world</parent><child>body</child></joint>"}));
  command(world, {500, 500, 500, 500});
  world.step(1000);
  const Joint hold = world.model("d").joint("hold").value();
  hold.reaction();
  world.step(2);
  const Vector3 drag = 4 * 500 * kDrag * Vector3(3, 4, 0);
  const Vector3 force = drag + Vector3(0, 0, 4 * kDroneThrust * 500 * 500 - kDroneMass * 9.8);
  // rotors stand 6 cm above the body; the rolling moment goes with the air's velocity, not across it
  const Vector3 torque = Vector3(0, 0, 0.06).cross(drag) + 4 * 500 * kRolling * Vector3(3, 4, 0);
  EXPECT_NEAR((hold.reaction().force + force).norm(), 0, 1e-6);
  EXPECT_NEAR((hold.reaction().torque + torque).norm(), 0, 1e-6);
}

TEST(MulticopterMotorModel, IsHeldBackByTheAir) {
  RunningWorld world(kWeightless + drone({.motor = "<motorConstant>0</motorConstant>"
                                                   "<rotorDragCoefficient>0.0005</rotorDragCoefficient>"
                                                   "<rollingMomentCoefficient>0</rollingMomentCoefficient>"}));
  command(world, {500, 500, 500, 500});
  world.step(500);
  world.model("d").setVelocity({0.01, 0, 2}, Vector3::Zero());
  world.step(100);
  // only what goes across the rotors is braked
  EXPECT_NEAR(velocityOf(world).z(), 2, 1e-3);
  EXPECT_NEAR(velocityOf(world).x(), 0.01 * std::exp(-4 * 500 * 0.0005 / kDroneMass * 0.1), 1e-4);
}

TEST(MulticopterMotorModel, ComesToItsSpeedWithItsTimeConstants) {
  RunningWorld world(
      kWeightless + drone({.motor = "<timeConstantUp>0.02</timeConstantUp><timeConstantDown>0.05</timeConstantDown>"}));
  command(world, {100, 200, 300, 400});
  world.step(20);
  for (const int i : {0, 1, 2, 3}) {
    const double expected = (i < 2 ? 1 : -1) * 100 * (i + 1) * (1 - std::exp(-1));
    EXPECT_NEAR(speedOf(world, i), expected, 1e-4);
  }
  world.step(1000);
  command(world, {0, 0, 0, 0});
  world.step(50);
  EXPECT_NEAR(speedOf(world, 3), -400 * std::exp(-1), 1e-4);
}

TEST(MulticopterMotorModel, TurnsTheJointSlower) {
  RunningWorld world(kWeightless + drone({.motor = "<rotorVelocitySlowdownSim>2</rotorVelocitySlowdownSim>"
                                                   "<maxRotVelocity>900</maxRotVelocity>"}));
  command(world, {5000, 700, 700, 700});
  world.step(500);
  EXPECT_NEAR(world.model("d").joint("joint0")->velocity(), 450, 1e-2);
  EXPECT_NEAR(world.model("d").joint("joint1")->velocity(), 350, 1e-2);
}

TEST(MulticopterMotorModel, PushesDownWhereItIsToldToTurnTheOtherWay) {
  RunningWorld world(kWeightless + drone({}));
  command(world, {-400, -400, -400, -400});
  world.step(500);
  const Vector3 before = velocityOf(world);
  world.step(100);
  EXPECT_NEAR(speedOf(world, 0), -400, 1e-3);
  EXPECT_NEAR((velocityOf(world) - before).z(), -4 * kDroneThrust * 400 * 400 / kDroneMass * 0.1, 1e-4);
}

TEST(MulticopterMotorModel, DoesWhatASystemOfTheModelSaysInPlaceOfTheTopic) {
  RunningWorld world(kWeightless + drone({}));
  world.model("d").setActuators(std::vector<double>{100, 100, 100, 50});
  command(world, {300, 300, 300, 300});
  world.step(500);
  EXPECT_NEAR(speedOf(world, 0), 100, 1e-3);
  EXPECT_NEAR(speedOf(world, 3), -50, 1e-3);
}

TEST(MulticopterMotorModel, TellsItsSpeed) {
  std::string text = drone({.motor = "<robotNamespace>my drone</robotNamespace>"});
  const std::string number = "<motorNumber>2</motorNumber>";
  text.insert(text.find(number), "<motorSpeedPubTopic>speed</motorSpeedPubTopic>");
  RunningWorld world(kWeightless + text);
  std::vector<ignition::msgs::Double> messages;
  world.listen("/my_drone/speed", messages);
  world.tell("/my_drone/motor_speed", speeds({100, 100, 200, 100}));
  world.step(500);
  ASSERT_EQ(messages.size(), 500U);
  EXPECT_NEAR(messages[499].data(), -200, 1e-2);
}

// it is what later releases call the number
TEST(MulticopterMotorModel, TakesItsNumberFromTheActuatorNumber) {
  std::string text = drone({});
  for (const auto& [from, to] : {std::pair("<motorNumber>0</motorNumber>", "<actuator_number>3</actuator_number>"),
                                 {"<motorNumber>3<", "<actuator_number>0</actuator_number><motorNumber>9<"}}) {
    text.replace(text.find(from), std::string(from).size(), to);
  }
  RunningWorld world(kWeightless + text);
  command(world, {100, 200, 300, 400});
  world.step(500);
  EXPECT_NEAR(speedOf(world, 0), 400, 1e-3);
  EXPECT_NEAR(speedOf(world, 3), -100, 1e-3);
}

TEST(MulticopterMotorModel, IgnoresCommandsThatMakeNoSense) {
  RunningWorld world(kWeightless + drone({}));
  command(world, {100, 100, 100, 100});
  world.step(300);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {infinity, -infinity, std::nan(""), 1e308, -1e308}) {
    command(world, {value, value, value, value});
    world.step(100);
    EXPECT_NEAR(speedOf(world, 0), 100, 1e-3) << value;
  }
  command(world, {50, 50, 50});
  world.step(300);
  EXPECT_NEAR(speedOf(world, 0), 50, 1e-3);
  // no speed is for this one
  EXPECT_NEAR(speedOf(world, 3), -100, 1e-3);
  // as much as it can
  command(world, {1e5, 1e5, 1e5, 1e5});
  world.step(300);
  EXPECT_NEAR(speedOf(world, 3), -838, 1e-3);
}

TEST(MulticopterMotorModel, RestsWhilePausedAndAfterAReset) {
  RunningWorld world(kWeightless + drone({}));
  command(world, {100, 100, 100, 100});
  for (int i = 0; i < 50; ++i) world.simulation().stepPaused();
  EXPECT_EQ(speedOf(world, 0), 0);
  world.step(300);
  EXPECT_NEAR(speedOf(world, 0), 100, 1e-3);
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  world.step(10);
  EXPECT_EQ(speedOf(world, 0), 0);
}

TEST(MulticopterMotorModel, GoesOnFromASavedState) {
  RunningWorld world(drone({}));
  command(world, {100, 200, 300, 400});
  world.step(15);
  RunningWorld other(drone({}));
  test::expectSameBitsFromSavedState(world, other, 100);
}

TEST(MulticopterMotorModel, SaysWhatIsWrongWithAMotor) {
  const auto complaint = [](const std::string& from, const std::string& to) {
    std::string text = drone({.motor = "<motorType>velocity</motorType>"});
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    const auto complaints = RunningWorld::complaintsAbout(text.replace(at, from.size(), to));
    return complaints.size() == 1 ? complaints[0] : std::to_string(complaints.size()) + " complaints";
  };
  const std::string left = "multicopter-motor-model of d is left out: ";
  const std::array<std::array<std::string, 3>, 14> cases{{
      {"<jointName>joint0", "<jointName>joint9", left + "<jointName> 'joint9' is not a joint of model 'd'"},
      {"<linkName>rotor0", "<linkName>rotor9", left + "<linkName> 'rotor9' is not a link of model 'd'"},
      {"<linkName>rotor0</linkName>", "", left + "no <linkName> is given"},
      {"<parent>body</parent><child>rotor0", "<parent>world</parent><child>rotor0",
       left + "<jointName> 'joint0' is connected to the world, which can't fly"},
      {"<motorType>velocity", "<motorType>force", left + "a motor of the type 'force' has no effect, as in Fortress"},
      {"<motorType>velocity", "<motorType>position",
       left + "a motor of the type 'position' has no effect, as in Fortress"},
      {"<motorType>velocity", "<motorType>speed", "<motorType> is 'speed': 'velocity' is used"},
      {"<turningDirection>ccw", "<turningDirection>left", "<turningDirection> is 'left': 'cw' is used"},
      {"<turningDirection>ccw</turningDirection>", "", "a rotor without a <turningDirection> turns clockwise"},
      {"<motorNumber>0</motorNumber>", "", "a rotor without an <actuator_number> has the number 0"},
      {"<motorNumber>0", "<motorNumber>-1", left + "<motorNumber> must be zero or more"},
      {"<motorNumber>0", "<timeConstantUp>-1</timeConstantUp><motorNumber>0",
       left + "<timeConstantUp> must be zero or more"},
      {"<motorNumber>0", "<rotorVelocitySlowdownSim>0</rotorVelocitySlowdownSim><motorNumber>0",
       left + "<rotorVelocitySlowdownSim> must be above zero"},
      {"<motorNumber>0", "<momentConstant>-1</momentConstant><motorNumber>0",
       "<momentConstant> is negative: its force or torque acts in the wrong direction"},
  }};
  for (const auto& [from, to, expected] : cases) EXPECT_EQ(complaint(from, to), expected) << to;
}

// As Fortress's test of the same name.
TEST(MulticopterMotorModel, CommandedMotorSpeed) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "Fortress's worlds are not here";
  RunningWorld world(*worlds / "test/quadcopter.sdf");
  world.step(100);
  world.tell("/X3/gazebo/command/motor_speed", speeds({100, 100, 100, 100}));
  world.step(500);
  for (const Joint& joint : world.model("X3").joints()) EXPECT_NEAR(std::abs(joint.velocity()), 100, 1e-2);
}

}  // namespace
}  // namespace pongsim::multicopter_motor_model_test
