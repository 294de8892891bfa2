#include "support/ros2/healthy_robot.hh"

namespace pongsim::ros2 {
namespace {

using enum Finding::Verdict;
using test::expectOne;
using test::frameIn;
using test::healthyRobot;

TEST(DoctorFrameChecks, FindFramesWithSeveralSources) {
  Observation seen = healthyRobot();
  seen.frames["wheel"].parents.insert("chassis");
  expectOne(checkFrames(seen, {}), kFault, "frame 'wheel' has 2 parents: 'base_link', 'chassis'", "--ros2-no-tf");
  seen = healthyRobot();
  seen.frames["wheel"].publishers.insert(Guid{{1}});
  expectOne(checkFrames(seen, {}), kFault, "frame 'wheel' has 2 publishers", "--ros2-no-tf");
}

TEST(DoctorFrameChecks, FindALoop) {
  Observation seen = healthyRobot();
  seen.frames["a"] = frameIn("a");
  expectOne(checkFrames(seen, {}), kFault, "frame 'a' is its own ancestor", "--ros2-no-tf");
}

TEST(DoctorFrameChecks, FindNamesOfRep105ThatAreMissing) {
  Observation seen = healthyRobot();
  seen.frames = {{"robot/odom", frameIn("map", 50)}, {"base_link", frameIn("robot/odom", 50)}};
  expectOne(checkFrames(seen, {}), kFault, "no frame 'odom'", "<frame_id>odom</frame_id>");
  expectOne(checkFrames(seen, {.framePrefix = "robot/"}), kFault, "no frame 'robot/base_link'",
            "<child_frame_id>robot/base_link</child_frame_id>");
  seen = healthyRobot();
  seen.frames.erase("odom");
  expectOne(checkFrames(seen, {}), kHint, "no frame 'map'", "slam_toolbox");
  expectOne(checkFrames({}, {}), kFault, "no frames on /tf and /tf_static", "--ros2-no-tf");
}

TEST(DoctorFrameChecks, FindABaseThatIsNotBelowOdom) {
  Observation seen = healthyRobot();
  seen.frames["base_link"] = frameIn("world", 50);
  expectOne(checkFrames(seen, {}), kFault, "'base_link' is not below 'odom', but below 'world'", "<child_frame_id>");
}

TEST(DoctorFrameChecks, FindStampsThatGoBackAndRatesThatAreLow) {
  Observation seen = healthyRobot();
  seen.frames["wheel"].stamps.goBack = true;
  expectOne(checkFrames(seen, {}), kFault, "stamps of frame 'wheel' go back", "second publisher");
  seen = healthyRobot();
  seen.frames["base_link"] = frameIn("odom", 2);
  expectOne(checkFrames(seen, {}), kFault, "frame 'base_link' comes 2 times a second", "<odom_publish_frequency>");
}

}  // namespace
}  // namespace pongsim::ros2
