#include "support/ros2/healthy_robot.hh"

namespace pongsim::ros2 {
namespace {

using enum Finding::Verdict;
using test::expectOne;

TEST(DoctorTimeChecks, FindAClockThatIsMissingOrStandsStill) {
  Observation seen = test::healthyRobot();
  seen.clock.last = seen.clock.first;
  expectOne(checkTime(seen), kFault, "/clock stands still", "pause: false");
  seen.endpoints.clear();
  expectOne(checkTime(seen), kFault, "nobody publishes /clock", "--ros2");
}

TEST(DoctorTimeChecks, FindTwoClocksAndOneThatWentBack) {
  Observation seen = test::healthyRobot();
  seen.clock.goBack = true;
  expectOne(checkTime(seen), kHint, "went back", "restart");
  test::addEndpoint(seen, "/clock", "rosgraph_msgs/msg/Clock");
  expectOne(checkTime(seen), kFault, "2 publishers of /clock", "ROS_DOMAIN_ID");
}

TEST(DoctorTimeChecks, FindNodesOnWallTime) {
  Observation seen = test::healthyRobot();
  seen.onWallTime = {"/amcl"};
  expectOne(checkTime(seen), kFault, "node '/amcl' runs on wall time", "use_sim_time:=true");
}

}  // namespace
}  // namespace pongsim::ros2
