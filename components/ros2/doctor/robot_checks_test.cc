#include "support/ros2/healthy_robot.hh"

namespace pongsim::ros2 {
namespace {

using enum Finding::Verdict;
using test::expectOne;
using test::healthyRobot;

TEST(DoctorRobotChecks, FindADescriptionThatIsMissingOrTwice) {
  Observation seen = healthyRobot();
  test::addEndpoint(seen, "/robot_description", "std_msgs/msg/String", Graph::Role::kWriter, kLatchedQos);
  expectOne(checkRobot(seen, {}), kFault, "2 publishers of '/robot_description'", "--ros2-no-robot-description");
  expectOne(checkRobot({}, {}), kFault, "nobody publishes '/robot_description'", "robot_state_publisher");
}

TEST(DoctorRobotChecks, FindADescriptionThatIsNotKeptOrNoUrdf) {
  Observation seen = healthyRobot();
  for (Graph::Endpoint& each : seen.endpoints) each.contract.qos.isTransientLocal = false;
  expectOne(checkRobot(seen, {}), kFault, "not kept for late subscribers", "transient local");
  seen = healthyRobot();
  seen.descriptions["/robot_description"] = "robot.urdf.xacro";
  expectOne(checkRobot(seen, {}), kFault, "is not a URDF robot", "xacro");
}

TEST(DoctorRobotChecks, FindLinksThatTfDoesNotKnow) {
  Observation seen = healthyRobot();
  seen.frames.erase("wheel");
  expectOne(checkRobot(seen, {}), kFault, "does not know the links 'wheel'", "robot_state_publisher");
}

TEST(DoctorRobotChecks, FindJointsThatNobodyTellsOf) {
  Observation seen = healthyRobot();
  seen.streams["/joint_states"].joints = {"other"};
  expectOne(checkRobot(seen, {}), kFault, "'/joint_states' lacks the joints 'axle'", "<joint_name>");
}

}  // namespace
}  // namespace pongsim::ros2
