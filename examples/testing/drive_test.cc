// A test of a robot with GoogleTest.
#include <pongsim/expect/world_test.hh>

namespace {

class Court : public pongsim::WorldTest {
 protected:
  void SetUp() override { load(WORLDS "/pong_world.sdf"); }
};

TEST_F(Court, TheRobotDrivesAsItIsTold) {
  publish("/cmd_vel", "Twist", "linear: {x: 0.5}");
  expect(topic("/model/pong_bot/odometry")).eventually(field("twist.linear.x").near(0.5, 0.02)).within(2);
  expect(pose("pong_bot")).always(field("z").near(0, 0.05));
  expect(contact("pong_bot", "court")).never();
  run(5);
}

}  // namespace
