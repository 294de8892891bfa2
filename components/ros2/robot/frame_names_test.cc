#include "ros2/robot/frame_names.hh"

#include "ros2/robot/robot_list.hh"
#include "support/ros2/robot_world.hh"

namespace pongsim::ros2 {
namespace {

using test::inWorld;
using test::worldOf;

/// A robot whose lidar is above its link, which a fixed joint holds, and whose camera is on the base.
std::string scout(const std::string& name, const std::string& odometry, const std::string& lidarFrame) {
  return "<model name='" + name +
         "'><link name='base_footprint'/><link name='base_link'><sensor name='eye' type='camera'><pose>1 0 0 0 0 0"
         "</pose><gz_frame_id>" +
         lidarFrame.substr(0, std::min(lidarFrame.find("base"), lidarFrame.size())) +
         "base_link</gz_frame_id></sensor></link>"
         "<link name='base_scan'><sensor name='lidar' type='gpu_lidar'><pose>0 0 2 0 0 0</pose>"
         "<frame_id>" +
         lidarFrame +
         "</frame_id></sensor></link>"
         "<joint name='a' type='fixed'><parent>base_footprint</parent><child>base_link</child></joint>"
         "<joint name='b' type='fixed'><parent>base_link</parent><child>base_scan</child></joint>"
         "<plugin filename='gz-sim-diff-drive-system' name='gz::sim::systems::DiffDrive'>" +
         odometry + "</plugin></model>";
}

std::vector<std::string> framesOfRobot(const Robot& robot) {
  std::vector<std::string> frames;
  for (const TreeLink& link : robot.tree.links) frames.push_back(link.frame);
  return frames;
}

TEST(FrameNames, AreThoseThatTheFileGivesToItsLinks) {
  struct Case {
    const char* odometry;
    const char* lidar;
    const char* prefix;
  };
  for (const auto& [odometry, lidar, prefix] :
       {Case{"<child_frame_id>base_footprint</child_frame_id>", "laser", ""},
        Case{"<robot_base_frame>r1/base_footprint</robot_base_frame>", "base_scan", "r1/"}, Case{"", "base_scan", ""},
        Case{"", "r2/base_scan", "r2/"}, Case{"<child_frame_id>base</child_frame_id>", "my_base_scan", "scout/"},
        Case{"", "scout::base_scan", "scout/"}}) {
    const auto simulation = worldOf(inWorld(scout("scout", odometry, lidar)));
    RobotList list(simulation->world(), {.prefix = "p/"}, {});
    ASSERT_TRUE(list.update());
    EXPECT_EQ(list.robots().front().tree.links.at(1).frame, "p/" + std::string(prefix) + "base_link")
        << odometry << lidar;
  }
}

TEST(FrameNames, OfALinkThatIsThereForItsSensorAreTheSensorsPlace) {
  const auto simulation = worldOf(inWorld(scout("scout", "", "base_scan")));
  RobotList list(simulation->world(), {}, {});
  testing::internal::CaptureStderr();
  ASSERT_TRUE(list.update());
  const std::string said = testing::internal::GetCapturedStderr();
  const Robot& robot = list.robots().front();
  EXPECT_EQ(framesOfRobot(robot), (std::vector<std::string>{"base_footprint", "base_link", "scout/base_scan"}));
  ASSERT_EQ(robot.sensors.size(), 1U);
  EXPECT_EQ(robot.sensors[0].frame, "base_scan");
  EXPECT_EQ(robot.sensors[0].parent, "scout/base_scan");
  EXPECT_EQ(robot.sensors[0].X_ParentSensor.position, Vector3(0, 0, 2));
  // a link that holds others stays where it is
  EXPECT_NE(said.find("sensor 'scout::base_link::eye' are in frame 'base_link'"), std::string::npos) << said;
}

TEST(FrameNames, OfASecondRobotWithTheSameBeginWithItsName) {
  const std::string odometry = "<child_frame_id>base_footprint</child_frame_id>";
  const auto simulation =
      worldOf(inWorld(scout("one", odometry, "laser") + scout("two", odometry, "laser") + scout("three", "", "x")));
  RobotList list(simulation->world(), {}, {});
  testing::internal::CaptureStderr();
  ASSERT_TRUE(list.update());
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("robot 'two' shares frame names with another robot: on /tf they are prefixed with 'two/'"),
            std::string::npos)
      << said;
  EXPECT_EQ(said.find("robot 'three' shares"), std::string::npos) << said;
  std::vector<std::string> roots;
  for (const Robot& robot : list.robots()) roots.push_back(robot.tree.links.front().frame);
  EXPECT_EQ(roots, (std::vector<std::string>{"base_footprint", "two/base_footprint", "three/base_footprint"}));
}

}  // namespace
}  // namespace pongsim::ros2
