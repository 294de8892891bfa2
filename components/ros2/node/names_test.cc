#include "ros2/node/names.hh"

#include <gtest/gtest.h>

namespace pongsim::ros2 {
namespace {

TEST(Names, OfTheSimulationBecomeNamesOfRos) {
  EXPECT_EQ(rosNameFor("/cmd_vel"), "/cmd_vel");
  EXPECT_EQ(rosNameFor("lidar"), "/lidar");
  EXPECT_EQ(rosNameFor("/model/my-robot 2/pose"), "/model/my_robot_2/pose");
  EXPECT_EQ(rosNameFor("/3d/scan"), "/_3d/scan");
  EXPECT_EQ(rosNameFor("//a//b/"), "/a/b");
  for (const char* topic : {"/cmd_vel", "lidar", "/model/my-robot 2/pose", "/3d/scan", "//a//b/"}) {
    EXPECT_EQ(rosNameError(rosNameFor(topic)), std::nullopt) << topic;
  }
}

TEST(Names, SayWhatIsWrongWithThem) {
  EXPECT_EQ(rosNameError("scan"), "is not an absolute name");
  EXPECT_EQ(rosNameError("/"), "is not an absolute name");
  EXPECT_EQ(rosNameError("/a/"), "ends with a slash");
  EXPECT_EQ(rosNameError("/a//b"), "has two slashes in a row");
  EXPECT_EQ(rosNameError("/a-b"), "has a '-', which ROS does not allow in names");
  EXPECT_EQ(rosNameError("/a/3d"), "has a word that begins with the digit 3");
}

TEST(Names, AreWithinTheNamespace) {
  EXPECT_EQ(absoluteName("/", "scan"), "/scan");
  EXPECT_EQ(absoluteName("", "scan"), "/scan");
  EXPECT_EQ(absoluteName("/robot", "scan"), "/robot/scan");
  EXPECT_EQ(absoluteName("robot", "scan"), "/robot/scan");
  EXPECT_EQ(absoluteName("/robot", "/scan"), "/scan");
}

TEST(Names, GoToTheWireAndBack) {
  EXPECT_EQ(topicOnWire("/scan"), "rt/scan");
  EXPECT_EQ(topicFromWire("rt/scan"), "/scan");
  EXPECT_EQ(topicFromWire("rq/addRequest"), std::nullopt);
  EXPECT_EQ(requestOnWire("/add"), "rq/addRequest");
  EXPECT_EQ(replyOnWire("/add"), "rr/addReply");
  EXPECT_EQ(serviceFromWire("rq/addRequest"), "/add");
  EXPECT_EQ(serviceFromWire("rr/addReply"), std::nullopt);
}

}  // namespace
}  // namespace pongsim::ros2
