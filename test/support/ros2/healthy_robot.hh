#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "ros2/doctor/checks.hh"
#include "ros2/node/names.hh"
#include "ros2/types/type_info.hh"

namespace pongsim::test {

/// Adds a publisher or a subscriber.
inline void addEndpoint(ros2::Observation& seen, const std::string& topic, const std::string& type,
                        ros2::Graph::Role role = ros2::Graph::Role::kWriter, const ros2::Qos& qos = {}) {
  ros2::Graph::Endpoint& added = seen.endpoints.emplace_back();
  added.id.bytes[15] = static_cast<std::uint8_t>(seen.endpoints.size());
  added.role = role;
  added.contract.topic = ros2::topicOnWire(topic);
  added.contract.type = ros2::ddsTypeName(type);
  added.contract.qos = qos;
}

inline ros2::Stamps stampsAt(double rate) { return {.count = 101, .first = 1, .last = 1 + 100 / rate}; }

inline ros2::FrameSeen frameIn(const std::string& parent, double rate = 0) {
  ros2::FrameSeen frame{.parents = {parent}, .publishers = {ros2::Guid{}}, .isStatic = rate == 0};
  frame.stamps = stampsAt(rate == 0 ? 1 : rate);
  return frame;
}

/// What is seen of a robot that has all that Nav2 needs.
inline ros2::Observation healthyRobot() {
  ros2::Observation seen;
  seen.clock = stampsAt(1000);
  seen.frames = {{"odom", frameIn("map", 20)},
                 {"base_link", frameIn("odom", 50)},
                 {"base_scan", frameIn("base_link")},
                 {"wheel", frameIn("base_link", 50)}};
  seen.streams = {
      {"/scan", {.type = "sensor_msgs/msg/LaserScan", .stamps = stampsAt(10), .frames = {"base_scan"}}},
      {"/odom",
       {.type = "nav_msgs/msg/Odometry", .stamps = stampsAt(50), .frames = {"odom"}, .childFrames = {"base_link"}}},
      {"/joint_states", {.type = "sensor_msgs/msg/JointState", .stamps = stampsAt(50), .joints = {"axle"}}}};
  // the clock is not far ahead of what came last
  for (auto& [topic, stream] : seen.streams) stream.stamps.last = std::min(stream.stamps.last, 3.0);
  addEndpoint(seen, "/clock", "rosgraph_msgs/msg/Clock");
  addEndpoint(seen, "/scan", "sensor_msgs/msg/LaserScan");
  addEndpoint(seen, "/odom", "nav_msgs/msg/Odometry");
  addEndpoint(seen, "/joint_states", "sensor_msgs/msg/JointState");
  addEndpoint(seen, "/robot_description", "std_msgs/msg/String", ros2::Graph::Role::kWriter, ros2::kLatchedQos);
  addEndpoint(seen, "/cmd_vel", "geometry_msgs/msg/Twist", ros2::Graph::Role::kReader);
  seen.descriptions["/robot_description"] =
      "<robot name='r'><link name='base_link'/><link name='base_scan'/><link name='wheel'/>"
      "<joint name='axle' type='continuous'><parent link='base_link'/><child link='wheel'/></joint>"
      "<joint name='mount' type='fixed'><parent link='base_link'/><child link='base_scan'/></joint></robot>";
  return seen;
}

/// Expects that exactly one finding is no good, with these words in its text and in the line that mends it.
inline void expectOne(const ros2::Findings& findings, ros2::Finding::Verdict verdict, const std::string& text,
                      const std::string& remedy) {
  ros2::Findings bad;
  for (const ros2::Finding& each : findings) {
    if (each.verdict != ros2::Finding::Verdict::kGood) bad.push_back(each);
  }
  std::string all;
  for (const ros2::Finding& each : bad) all += each.text + " | " + each.remedy + "\n";
  ASSERT_EQ(bad.size(), 1U) << all;
  EXPECT_EQ(bad[0].verdict, verdict);
  EXPECT_NE(bad[0].text.find(text), std::string::npos) << all;
  EXPECT_NE(bad[0].remedy.find(remedy), std::string::npos) << all;
}

}  // namespace pongsim::test
