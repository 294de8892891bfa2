#include "support/ros2/healthy_robot.hh"

namespace pongsim::ros2 {
namespace {

using enum Finding::Verdict;
using test::addEndpoint;
using test::expectOne;
using test::healthyRobot;
using test::stampsAt;

TEST(DoctorTopicChecks, FindTopicsWithOtherNames) {
  Observation seen = healthyRobot();
  for (Graph::Endpoint& each : seen.endpoints) {
    if (each.contract.topic == "rt/scan") each.contract.topic = "rt/lidar";
  }
  seen.streams.extract("/scan");
  seen.streams["/lidar"] = {.type = "sensor_msgs/msg/LaserScan", .stamps = stampsAt(100), .frames = {"base_scan"}};
  expectOne(checkTopics(seen, {}), kFault, "nobody publishes '/scan' [sensor_msgs/msg/LaserScan]; there is '/lidar'",
            "<topic>scan</topic>");
}

TEST(DoctorTopicChecks, FindTopicsOfANamespace) {
  const Findings findings = checkTopics(healthyRobot(), {.nameSpace = "/r1"});
  EXPECT_EQ(findings.at(0).verdict, kFault);
  EXPECT_EQ(findings.at(0).text.find("nobody publishes '/r1/scan'"), 0U) << findings.at(0).text;
}

TEST(DoctorTopicChecks, FindLowRatesAndSilence) {
  Observation seen = healthyRobot();
  seen.streams["/odom"].stamps = {.count = 3, .first = 1, .last = 2};
  expectOne(checkTopics(seen, {}), kFault, "'/odom' [nav_msgs/msg/Odometry] comes 2 times a second; 10 is the least",
            "<odom_publish_frequency>50");
  seen.streams.erase("/odom");
  expectOne(checkTopics(seen, {}), kHint, "nothing came on '/odom'", "--time 10");
}

TEST(DoctorTopicChecks, FindSecondPublishers) {
  Observation seen = healthyRobot();
  addEndpoint(seen, "/joint_states", "sensor_msgs/msg/JointState");
  NodeInfo& node = seen.nodes.emplace_back();
  node.nameSpace = "/";
  node.name = "broadcaster";
  node.publishes = {{"/joint_states", ""}};
  expectOne(checkTopics(seen, {}), kFault, "'/joint_states' has 2 publishers: /broadcaster", "--ros2-no-joint-states");
}

TEST(DoctorTopicChecks, FindStampsOfAnotherClock) {
  Observation seen = healthyRobot();
  seen.streams["/odom"].stamps.last = 1.7e9;
  seen.streams["/odom"].stamps.count = 2;
  expectOne(checkTopics(seen, {}), kFault, "the stamps of '/odom' are not of /clock: 1700000000 s",
            "--ros2-override-timestamps");
}

TEST(DoctorTopicChecks, FindFramesThatTfDoesNotKnow) {
  Observation seen = healthyRobot();
  seen.streams["/scan"].frames = {"robot/lidar"};
  expectOne(checkTopics(seen, {}), kFault, "'/scan' is in frame 'robot/lidar', which tf does not know", "<frame_id>");
  seen = healthyRobot();
  seen.frames["post"] = test::frameIn("world");
  seen.streams["/scan"].frames = {"post"};
  expectOne(checkTopics(seen, {}), kHint, "frame 'post', which is not connected to 'odom'", "<ground_truth>");
  seen = healthyRobot();
  seen.streams["/odom"].childFrames = {"chassis"};
  expectOne(checkTopics(seen, {}), kFault, "'/odom' is about frame 'chassis'", "<child_frame_id>");
}

TEST(DoctorTopicChecks, FindMissingCovariances) {
  Observation seen = healthyRobot();
  addEndpoint(seen, "/imu", "sensor_msgs/msg/Imu");
  StreamSeen& imu = seen.streams["/imu"] = {
      .type = "sensor_msgs/msg/Imu", .stamps = stampsAt(100), .frames = {"base_link"}, .lacksVariances = true};
  expectOne(checkTopics(seen, {}), kHint, "'/imu' has no covariances", "<stddev>");
  imu.lacksVariances = false;
  seen.streams["/odom"].lacksVariances = true;
  expectOne(checkTopics(seen, {}), kHint, "'/odom' has no covariances", "<gaussian_noise>");
}

TEST(DoctorTopicChecks, FindImagesWithoutTheirCameraInfo) {
  Observation seen = healthyRobot();
  const auto add = [&](const std::string& topic, const std::string& type, const std::string& frame) {
    addEndpoint(seen, topic, "sensor_msgs/msg/" + type);
    seen.streams[topic] = {.type = "sensor_msgs/msg/" + type, .stamps = stampsAt(100), .frames = {frame}};
  };
  add("/camera/image_raw", "Image", "base_scan");
  expectOne(checkTopics(seen, {}), kHint, "image '/camera/image_raw' has no '/camera/camera_info'", "image_raw");
  add("/camera/camera_info", "CameraInfo", "base_link");
  expectOne(checkTopics(seen, {}), kFault,
            "'/camera/image_raw' is in frame 'base_scan', its camera_info in 'base_link'", "<optical_frame_id>");
}

}  // namespace
}  // namespace pongsim::ros2
