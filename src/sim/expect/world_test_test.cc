#include "pongsim/expect/world_test.hh"

#include <gtest/gtest-spi.h>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::test {
namespace {

class Court : public WorldTest {
 protected:
  void SetUp() override { load(projectFolder() / "worlds/pong_world.sdf"); }
};

TEST_F(Court, TheRobotDrivesAndStops) {
  publish("/cmd_vel", "Twist", "linear: {x: 0.5}");
  expect(topic("/model/pong_bot/odometry")).eventually(field("pose.position.x") > 0.3).within(2);
  expect(pose("pong_bot")).always(field("z").near(0, 0.1), field("roll").between(-0.1, 0.1));
  expect(contact("pong_bot", "court")).never();
  expect(velocity("pong_bot")).first(field("x") > 0.1).then(pose("pong_bot"), field("x") >= 0.5).within(3);
  run(3);
  EXPECT_LT(simulation().time(), fromSeconds(3.01));
}

TEST_F(Court, WhatIsNotMetFailsAtItsLine) {
  expect(joint("pong_bot::left_wheel_joint")).eventually(field("position") > 1).within(0.5).lasting(0.1);
  EXPECT_NONFATAL_FAILURE(run(1),
                          "expected: eventually joint pong_bot::left_wheel_joint: position > 1, for 0.1 s on end, "
                          "within 0.5 s\nseen:     position = ");
  expect(pose("pong_bt")).never(field("z") > 1);
  EXPECT_NONFATAL_FAILURE(run(1), "there is no model 'pong_bt' (did you mean 'pong_bot'?)");
}

TEST_F(Court, MessagesThatAreExpectedAreSeen) {
  publish("/flag", "Boolean", "data: true");
  expect(topic("/flag")).eventually(field("data") == true).within(0.01);
  run(1);
}

TEST_F(Court, ExpectationsCanBeAddedBetweenRuns) {
  run(1);
  EXPECT_EQ(simulation().time(), fromSeconds(1));
  expect(topic("/model/pong_bot/odometry")).never(field("twist.linear.x") > 0.001).during(0, 0.5);
  expect(pose("pong_bot")).always(field("x").near(0, 0.01)).at(1.5);
  run(1);
}

}  // namespace
}  // namespace pongsim::test
