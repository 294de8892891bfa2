#include "support/ros2/healthy_robot.hh"

namespace pongsim::ros2 {
namespace {

TEST(DoctorCommandChecks, FindARobotThatHearsNobody) {
  test::expectOne(checkCommands(test::healthyRobot(), {.nameSpace = "/r1"}), Finding::Verdict::kFault,
                  "nobody subscribes to '/r1/cmd_vel'", "<topic>cmd_vel</topic>");
}

TEST(DoctorCommandChecks, FindStampedCommandsForARobotThatHearsOthers) {
  Observation seen = test::healthyRobot();
  test::addEndpoint(seen, "/cmd_vel", "geometry_msgs/msg/TwistStamped");
  test::expectOne(checkCommands(seen, {}), Finding::Verdict::kFault, "commands on '/cmd_vel' are stamped",
                  "'/cmd_vel@geometry_msgs/msg/TwistStamped@ignition.msgs.Twist'");
}

}  // namespace
}  // namespace pongsim::ros2
