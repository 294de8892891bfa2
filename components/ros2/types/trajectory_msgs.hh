#pragma once

#include <string>
#include <vector>

#include "ros2/types/builtin_interfaces.hh"
#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2::trajectory_msgs {

struct JointTrajectoryPoint {
  static constexpr const char* kName = "trajectory_msgs/msg/JointTrajectoryPoint";
  std::vector<double> positions;
  std::vector<double> velocities;
  std::vector<double> accelerations;
  std::vector<double> effort;
  builtin_interfaces::Duration time_from_start;
  static void visit(auto& self, auto&& field) {
    field("positions", self.positions);
    field("velocities", self.velocities);
    field("accelerations", self.accelerations);
    field("effort", self.effort);
    field("time_from_start", self.time_from_start);
  }
  bool operator==(const JointTrajectoryPoint&) const = default;
};

struct JointTrajectory {
  static constexpr const char* kName = "trajectory_msgs/msg/JointTrajectory";
  std_msgs::Header header;
  std::vector<std::string> joint_names;
  std::vector<JointTrajectoryPoint> points;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("joint_names", self.joint_names);
    field("points", self.points);
  }
  bool operator==(const JointTrajectory&) const = default;
};

struct MultiDOFJointTrajectoryPoint {
  static constexpr const char* kName = "trajectory_msgs/msg/MultiDOFJointTrajectoryPoint";
  std::vector<geometry_msgs::Transform> transforms;
  std::vector<geometry_msgs::Twist> velocities;
  std::vector<geometry_msgs::Twist> accelerations;
  builtin_interfaces::Duration time_from_start;
  static void visit(auto& self, auto&& field) {
    field("transforms", self.transforms);
    field("velocities", self.velocities);
    field("accelerations", self.accelerations);
    field("time_from_start", self.time_from_start);
  }
  bool operator==(const MultiDOFJointTrajectoryPoint&) const = default;
};

struct MultiDOFJointTrajectory {
  static constexpr const char* kName = "trajectory_msgs/msg/MultiDOFJointTrajectory";
  std_msgs::Header header;
  std::vector<std::string> joint_names;
  std::vector<MultiDOFJointTrajectoryPoint> points;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("joint_names", self.joint_names);
    field("points", self.points);
  }
  bool operator==(const MultiDOFJointTrajectory&) const = default;
};

}  // namespace pongsim::ros2::trajectory_msgs
