#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/running_world.hh"

// A plane of the kind of PX4's: wings and rudders by LiftDrag, servos on hinges with strong damping whose links weigh
// next to nothing, a propeller, wheels, and steps of 4 ms.
namespace pongsim::plane_test {
namespace {

using test::RunningWorld;

constexpr double kLimit = 0.5;
const std::vector<std::string> kServos{"left_aileron", "right_aileron", "elevator", "rudder"};

std::string inertial(double mass, double inertia) {
  const std::string i = std::to_string(inertia);
  return "<inertial><mass>" + std::to_string(mass) + "</mass><inertia><ixx>" + i + "</ixx><iyy>" + i + "</iyy><izz>" +
         i + "</izz></inertia></inertial>";
}

std::string servo(const std::string& name, const std::string& axis) {
  return "<link name='" + name + "'>" + inertial(1e-5, 1e-6) + "</link><joint name='" + name +
         "_hinge' type='revolute'><parent>body</parent><child>" + name + "</child><axis><xyz>" + axis +
         "</xyz><limit><lower>-0.5</lower><upper>0.5</upper></limit><dynamics><damping>1</damping></dynamics></axis>"
         "</joint><plugin filename='gz-sim-joint-position-controller-system' "
         "name='gz::sim::systems::JointPositionController'><joint_name>" +
         name + "_hinge</joint_name><sub_topic>" + name + "</sub_topic><p_gain>10</p_gain></plugin>";
}

std::string surface(const std::string& name, const std::string& place, const std::string& area,
                    const std::string& rest) {
  return "<plugin filename='gz-sim-lift-drag-system' name='gz::sim::systems::LiftDrag'><link_name>body</link_name>"
         "<control_joint_name>" +
         name + "_hinge</control_joint_name><cp>" + place + "</cp><area>" + area +
         "</area><air_density>1.2</air_density><cla>4.75</cla><cda>0.6</cda><alpha_stall>0.34</alpha_stall>"
         "<cla_stall>-3.85</cla_stall><cda_stall>-0.9</cda_stall><forward>1 0 0</forward>" +
         rest + "</plugin>";
}

std::string wheel(const std::string& name, const std::string& place) {
  return "<link name='" + name + "'><pose>" + place + " 0 0 0</pose>" + inertial(0.05, 3e-5) +
         "<collision name='c'><geometry><sphere><radius>0.03</radius></sphere></geometry></collision></link><joint "
         "name='" +
         name + "_axle' type='revolute'><parent>body</parent><child>" + name +
         "</child><axis><xyz>0 1 0</xyz></axis></joint>";
}

std::string plane() {
  std::string text =
      "<physics name='p' type='ode'><max_step_size>0.004</max_step_size></physics><model name='ground'>"
      "<static>true</static><link name='l'><collision name='c'><geometry><plane/></geometry></collision></link></model>"
      "<model name='plane'><pose>0 0 0.16 0 0 0</pose><link name='body'>" +
      inertial(1.2, 0.15) + "</link>";
  text += wheel("left_wheel", "-0.04 0.13 -0.13") + wheel("right_wheel", "-0.04 -0.13 -0.13") +
          wheel("nose_wheel", "0.14 0 -0.13");
  for (const std::string& name : kServos) text += servo(name, name == "rudder" ? "0 0 1" : "0 1 0");
  const std::string wing = "<a0>0.06</a0><upward>0 0 1</upward><control_joint_rad_to_cl>-0.3</control_joint_rad_to_cl>";
  text += surface("left_aileron", "-0.05 0.3 0.05", "0.3", wing);
  text += surface("right_aileron", "-0.05 -0.3 0.05", "0.3", wing);
  text += surface("elevator", "-0.5 0 0", "0.03",
                  "<a0>-0.1</a0><upward>0 0 1</upward><control_joint_rad_to_cl>-4</control_joint_rad_to_cl>");
  text += surface("rudder", "-0.5 0 0.05", "0.05",
                  "<upward>0 1 0</upward><control_joint_rad_to_cl>0.8</control_joint_rad_to_cl>");
  return text + "<link name='propeller'><pose>0.25 0 0 0 1.5707963267948966 0</pose>" + inertial(0.005, 1e-5) +
         "</link><joint name='shaft' type='revolute'><parent>body</parent><child>propeller</child>"
         "<axis><xyz>0 0 1</xyz></axis></joint>"
         "<plugin filename='gz-sim-multicopter-motor-model-system' name='gz::sim::systems::MulticopterMotorModel'>"
         "<jointName>shaft</jointName><linkName>propeller</linkName><actuator_number>0</actuator_number>"
         "<turningDirection>cw</turningDirection><commandSubTopic>command/motor_speed</commandSubTopic>"
         "<maxRotVelocity>1000</maxRotVelocity><motorConstant>1e-5</motorConstant><motorType>velocity</motorType>"
         "<momentConstant>0.01</momentConstant></plugin></model>";
}

void tellServos(RunningWorld& world, double angle) {
  for (const std::string& name : kServos) world.tellNumber("/model/plane/" + name, angle);
}

/// Makes steps. @return The largest angle of a servo meanwhile [rad].
double largestAngle(RunningWorld& world, int steps) {
  double largest = 0;
  for (int i = 0; i < steps; ++i) {
    world.step(1);
    for (const std::string& name : kServos) {
      largest = std::max(largest, std::abs(world.model("plane").joint(name + "_hinge")->position()));
    }
  }
  return largest;
}

TEST(Plane, KeepsItsControlSurfacesWithinTheirLimits) {
  RunningWorld world(plane());
  for (const double angle : {5.0, -5.0}) {
    tellServos(world, angle);
    EXPECT_LT(largestAngle(world, 500), kLimit + 1e-3);
    for (const std::string& name : kServos) {
      EXPECT_NEAR(world.model("plane").joint(name + "_hinge")->position(), std::copysign(kLimit, angle), 1e-3);
    }
  }
}

// p = 10 N m/rad against a damping of 1 N m s/rad: the angle comes near its goal by 10 / s
TEST(Plane, MovesItsControlSurfacesAsItsServosAre) {
  RunningWorld world(plane());
  tellServos(world, 0.3);
  world.step(25);
  for (const std::string& name : kServos) {
    EXPECT_NEAR(world.model("plane").joint(name + "_hinge")->position(), 0.3 * (1 - std::exp(-1)), 0.01);
  }
}

TEST(Plane, TakesOffAndClimbs) {
  RunningWorld world(plane());
  const Link body = world.model("plane").link("body").value();
  world.step(250);
  EXPECT_LT(body.linearVelocity().norm(), 1e-3);
  world.tellText("/plane/command/motor_speed", "ignition.msgs.Actuators", "velocity: [1000]");
  double largest = largestAngle(world, 250);
  // 10 N on 1.4 kg
  EXPECT_NEAR(body.linearVelocity().x(), 10 / 1.355, 1);
  world.tellNumber("/model/plane/elevator", -0.05);
  largest = std::max(largest, largestAngle(world, 1500));
  EXPECT_GT(body.pose().position.z(), 3);
  EXPECT_LT(largest, kLimit);
  EXPECT_TRUE(body.pose().position.allFinite());
}

}  // namespace
}  // namespace pongsim::plane_test
