// Drops and drives a robot of TurtleBot3's kind: two wheels and a caster, with the contact parameters that robots for
// Gazebo Classic have. What Fortress's engine makes of it (DART 6.12.1, ign-physics 5.1) was measured with the same
// SDF.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "physics/engine.hh"
#include "sdf/loader.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim {
namespace {

constexpr Time kStepOfRobot = std::chrono::milliseconds(1);
constexpr double kRobotStep = 1e-3;
// [m/s]: contacts are a little soft
constexpr double kCreep = 2e-5;
constexpr const char* kParameters =
    "<contact><ode><kp>1e5</kp><kd>1</kd><max_vel>0.01</max_vel><min_depth>0.001</min_depth></ode></contact>";

std::string wheel(const std::string& side, const std::string& y, const std::string& contact) {
  return "<link name='" + side + "'><pose>0 " + y +
         " 0.04 -1.5707963267948966 0 0</pose><inertial><mass>0.1</mass><inertia><ixx>5e-5</ixx><iyy>5e-5</iyy>"
         "<izz>8e-5</izz></inertia></inertial><collision name='tire'><geometry><cylinder><radius>0.04</radius>"
         "<length>0.02</length></cylinder></geometry><surface><friction><ode><mu>100000</mu><mu2>100000</mu2></ode>"
         "</friction>" +
         contact + "</surface></collision></link><joint name='" + side +
         "_joint' type='revolute'><parent>base</parent><child>" + side +
         "</child><axis><xyz>0 0 1</xyz></axis></joint>";
}

/// A world with a plane and the robot at this height. Its wheels stand on the plane at 0 m.
std::string worldWith(const std::string& height, const std::string& contact) {
  return "<sdf version='1.9'><world name='w'><model name='ground'><static>true</static><link name='l'><collision "
         "name='c'><geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link></model>"
         "<model name='robot'><pose>0 0 " +
         height +
         " 0 0 0</pose><link name='base'><inertial><pose>-0.03 0 0.07 0 0 0</pose><mass>1</mass><inertia>"
         "<ixx>0.004</ixx><iyy>0.004</iyy><izz>0.006</izz></inertia></inertial><collision name='c'>"
         "<pose>-0.03 0 0.07 0 0 0</pose><geometry><box><size>0.16 0.14 "
         "0.08</size></box></geometry></collision></link>" +
         wheel("left", "0.09", contact) + wheel("right", "-0.09", contact) +
         "<link name='caster'><pose>-0.09 0 0.01 0 0 0</pose><inertial><mass>0.02</mass><inertia><ixx>1e-5</ixx>"
         "<iyy>1e-5</iyy><izz>1e-5</izz></inertia></inertial><collision name='ball'><geometry><sphere>"
         "<radius>0.01</radius></sphere></geometry><surface>" +
         contact +
         "</surface></collision></link><joint name='caster_joint' type='ball'><parent>base</parent>"
         "<child>caster</child></joint></model></world></sdf>";
}

sdf::Root loaded(const std::string& text) {
  Diagnostics diagnostics;
  sdf::Root root = sdf::loadText(text, "robot.sdf", diagnostics, {});
  for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  return root;
}

class Robot {
 public:
  Robot(const std::string& height, const std::string& contact)
      : root_(loaded(worldWith(height, contact))),
        entities_(root_.worlds.front()),
        state_(entities_),
        engine_(entities_) {}

  void step(int count) {
    for (int i = 0; i < count; ++i) engine_.step(kStepOfRobot, state_);
  }
  /// Speeds its wheels up by 25 rad/s², which is 1 m/s², to this speed [rad/s].
  void drive(double speed, int steps) {
    const world::Slot robot = entities_.findModel("robot");
    for (int i = 1; i <= steps; ++i) {
      const double now = std::min(speed, 25 * kRobotStep * i);
      engine_.setJointVelocityTarget(entities_.findJoint(robot, "left_joint"), now);
      engine_.setJointVelocityTarget(entities_.findJoint(robot, "right_joint"), now);
      step(1);
    }
  }
  const world::LinkState& base() const { return state_.links[entities_.findLink("robot::base")]; }
  std::vector<Pose> poses() const {
    std::vector<Pose> poses;
    for (const world::LinkState& link : state_.links) poses.push_back(link.X_WorldLink);
    return poses;
  }

 private:
  sdf::Root root_;
  world::Entities entities_;
  world::State state_;
  physics::Engine engine_;
};

TEST(SmallRobot, RestsWhereItIsDropped) {
  Robot robot("0.05", kParameters);
  robot.step(3000);
  const world::LinkState& base = robot.base();
  EXPECT_LT(base.X_WorldLink.position.norm(), 1e-4);
  EXPECT_LT(base.X_WorldLink.rotation.vec().norm(), 1e-4);
  EXPECT_LT(base.v_WorldLink.norm(), kCreep);
}

TEST(SmallRobot, IsNotThrownOutOfTheGround) {
  Robot robot("-0.01", kParameters);
  for (int i = 0; i < 3000; ++i) {
    robot.step(1);
    ASSERT_LT(robot.base().X_WorldLink.position.z(), 1e-4) << i;
  }
  EXPECT_NEAR(robot.base().X_WorldLink.position.z(), 0, 1e-4);
  EXPECT_LT(robot.base().X_WorldLink.position.head<2>().norm(), 2e-3);
}

TEST(SmallRobot, DrivesAsFarAsInFortress) {
  Robot robot("0", kParameters);
  robot.drive(5, 5000);
  EXPECT_NEAR(robot.base().X_WorldLink.position.x(), 0.9801, 1e-3);
  EXPECT_NEAR(robot.base().X_WorldLink.position.y(), 0, 1e-3);
  EXPECT_LT(std::abs(robot.base().v_WorldLink.z()), kCreep);
}

TEST(SmallRobot, TakesTheSameBitsWithoutContactParameters) {
  for (const char* height : {"0.05", "-0.01"}) {
    Robot with(height, kParameters), without(height, "");
    for (Robot* robot : {&with, &without}) {
      robot->step(1000);
      robot->drive(5, 1000);
    }
    EXPECT_EQ(with.poses(), without.poses());
  }
}

}  // namespace
}  // namespace pongsim
