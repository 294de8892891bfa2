#include "ros2/control/joint_driver.hh"

#include <cmath>

#include "support/ros2/robot_world.hh"

namespace pongsim::ros2 {
namespace {

using test::inWorld;
using test::worldOf;

/// Two arms on a base that is fixed to the world.
class JointDriverTest : public testing::Test {
 protected:
  JointDriver driver(const JointDriver::Settings& settings = {}) {
    std::vector<ControlledJoint> joints(2);
    joints[0].name = "first";
    joints[0].takesPosition = joints[0].takesVelocity = joints[0].takesEffort = true;
    joints[1].name = "second";
    joints[1].takesPosition = true;
    return {model_, joints, settings};
  }
  void step(JointDriver& driver, int count) {
    for (int i = 0; i < count; ++i) {
      driver.drive(fromSeconds(0.001));
      simulation_->step();
    }
  }
  double position(const char* joint) const { return model_.joint(joint)->position(); }
  double velocity(const char* joint) const { return model_.joint(joint)->velocity(); }

  static std::string arm(const std::string& name, const std::string& side) {
    return "<link name='" + name + "_arm'><pose>" + side +
           " 0 0 0 0 0</pose><inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia>"
           "</inertial></link><joint name='" +
           name + "' type='revolute'><parent>base</parent><child>" + name +
           "_arm</child><axis><xyz>0 0 1</xyz></axis></joint>";
  }

  std::unique_ptr<Simulation> simulation_ =
      worldOf(inWorld("<model name='m'><link name='base'/><joint name='hold' type='fixed'><parent>world</parent>"
                      "<child>base</child></joint>" +
                      arm("first", "1") + arm("second", "-1") + "</model>"));
  Model model_ = simulation_->world().model("m").value();
};

TEST_F(JointDriverTest, GoesToAPositionAsGzRos2ControlDoes) {
  JointDriver driver = this->driver();
  driver.command({{.position = 1.0}, {}});
  step(driver, 100);
  // 0.1 of the remaining distance in each period of 10 ms, ten times
  EXPECT_NEAR(position("first"), 1 - std::exp(-1.0), 0.01);
  step(driver, 2000);
  EXPECT_NEAR(position("first"), 1, 1e-6);
  EXPECT_NEAR(position("second"), 0, 1e-9);
}

TEST_F(JointDriverTest, TurnsAtAVelocityAndPushes) {
  JointDriver driver = this->driver();
  driver.command({{.velocity = 0.5}, {}});
  step(driver, 1000);
  EXPECT_NEAR(velocity("first"), 0.5, 1e-6);
  // the velocity command ends
  ASSERT_TRUE(model_.joint("first")->resetVelocity(0));
  driver.command({{.velocity = 0.5, .effort = 0.2}, {}});
  step(driver, 100);
  // 0.2 N m on 0.1 kg m^2 for 0.1 s
  EXPECT_NEAR(velocity("first"), 0.2, 0.005);
}

TEST_F(JointDriverTest, GoesTheWayWhoseCommandChangedLast) {
  JointDriver driver = this->driver();
  // both are always sent, as by topic_based_ros2_control
  driver.command({{.position = 0.0, .velocity = 1.0}, {}});
  step(driver, 100);
  EXPECT_NEAR(velocity("first"), 1, 1e-6);
  driver.command({{.position = 0.5, .velocity = 1.0}, {}});
  step(driver, 2000);
  EXPECT_NEAR(position("first"), 0.5, 1e-6);
}

TEST_F(JointDriverTest, HoldsWhatNobodyHasCommanded) {
  for (const bool holds : {false, true}) {
    JointDriver driver = this->driver({.holdsJoints = holds});
    ASSERT_TRUE(model_.joint("second")->resetVelocity(1));
    step(driver, 10);
    if (holds) {
      EXPECT_NEAR(velocity("second"), 0, 1e-9);
    } else {
      EXPECT_GT(velocity("second"), 0.9);
    }
  }
}

TEST_F(JointDriverTest, LetsAJointFollowAnother) {
  std::vector<ControlledJoint> joints(2);
  joints[0].name = "first";
  joints[0].takesPosition = true;
  joints[1].name = "second";
  joints[1].mimic = ControlledJoint::Mimic{"first", -2, 0.1};
  JointDriver driver(model_, joints, {});
  driver.command({{.position = 0.3}, {}});
  step(driver, 3000);
  EXPECT_NEAR(position("first"), 0.3, 1e-6);
  EXPECT_NEAR(position("second"), -0.5, 1e-5);
}

TEST_F(JointDriverTest, BeginsWhereItIsTold) {
  std::vector<ControlledJoint> joints(1);
  joints[0].name = "first";
  joints[0].takesPosition = true;
  joints[0].initialPosition = 0.7;
  JointDriver driver(model_, joints, {});
  EXPECT_TRUE(driver.begin().empty());
  EXPECT_NEAR(position("first"), 0.7, 1e-12);
}

TEST_F(JointDriverTest, RemembersCommandsInAState) {
  JointDriver driver = this->driver();
  driver.command({{.position = 1.0}, {}});
  StateArchive taking;
  driver.transfer(taking);
  const std::vector<std::byte> bytes = taking.take();
  JointDriver other = this->driver();
  StateArchive giving(bytes);
  other.transfer(giving);
  step(other, 100);
  EXPECT_GT(position("first"), 0.5);
  other.reset();
  step(other, 10);
  EXPECT_NEAR(velocity("first"), 0, 1e-6);
}

TEST_F(JointDriverTest, ObeysWhoClaimsAJoint) {
  using Interface = JointDriver::Interface;
  JointDriver driver = this->driver();
  driver.command({{.velocity = 3.0}, {}});
  step(driver, 10);
  // held until the first value
  driver.claim(0, Interface::kVelocity);
  step(driver, 10);
  EXPECT_NEAR(velocity("first"), 0, 1e-6);
  EXPECT_TRUE(std::isnan(driver.get(0, Interface::kVelocity)));
  driver.set(0, Interface::kVelocity, 1);
  driver.command({{.velocity = 3.0}, {}});
  step(driver, 10);
  EXPECT_NEAR(velocity("first"), 1, 1e-6);
  // velocity precedes
  driver.claim(0, Interface::kPosition);
  driver.set(0, Interface::kPosition, -1);
  step(driver, 10);
  EXPECT_NEAR(velocity("first"), 1, 1e-6);
  driver.release(0, Interface::kVelocity);
  step(driver, 2000);
  EXPECT_NEAR(position("first"), -1, 1e-3);
  driver.set(0, Interface::kPosition, NAN);
  step(driver, 10);
  EXPECT_NEAR(velocity("first"), 0, 1e-6);
  driver.release(0, Interface::kPosition);
  driver.command({{.velocity = 2.0}, {}});
  step(driver, 10);
  EXPECT_NEAR(velocity("first"), 2, 1e-6);
}

}  // namespace
}  // namespace pongsim::ros2
