#pragma once

#include <array>
#include <string>
#include <vector>

#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2::geometry_msgs {

struct Point {
  static constexpr const char* kName = "geometry_msgs/msg/Point";
  double x = 0;
  double y = 0;
  double z = 0;
  static void visit(auto& self, auto&& field) {
    field("x", self.x);
    field("y", self.y);
    field("z", self.z);
  }
  bool operator==(const Point&) const = default;
};

struct Quaternion {
  static constexpr const char* kName = "geometry_msgs/msg/Quaternion";
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;
  static void visit(auto& self, auto&& field) {
    field("x", self.x);
    field("y", self.y);
    field("z", self.z);
    field("w", self.w);
  }
  bool operator==(const Quaternion&) const = default;
};

struct Pose {
  static constexpr const char* kName = "geometry_msgs/msg/Pose";
  Point position;
  Quaternion orientation;
  static void visit(auto& self, auto&& field) {
    field("position", self.position);
    field("orientation", self.orientation);
  }
  bool operator==(const Pose&) const = default;
};

struct PoseArray {
  static constexpr const char* kName = "geometry_msgs/msg/PoseArray";
  std_msgs::Header header;
  std::vector<Pose> poses;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("poses", self.poses);
  }
  bool operator==(const PoseArray&) const = default;
};

struct PoseStamped {
  static constexpr const char* kName = "geometry_msgs/msg/PoseStamped";
  std_msgs::Header header;
  Pose pose;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("pose", self.pose);
  }
  bool operator==(const PoseStamped&) const = default;
};

struct PoseWithCovariance {
  static constexpr const char* kName = "geometry_msgs/msg/PoseWithCovariance";
  Pose pose;
  std::array<double, 36> covariance{};
  static void visit(auto& self, auto&& field) {
    field("pose", self.pose);
    field("covariance", self.covariance);
  }
  bool operator==(const PoseWithCovariance&) const = default;
};

struct Vector3 {
  static constexpr const char* kName = "geometry_msgs/msg/Vector3";
  double x = 0;
  double y = 0;
  double z = 0;
  static void visit(auto& self, auto&& field) {
    field("x", self.x);
    field("y", self.y);
    field("z", self.z);
  }
  bool operator==(const Vector3&) const = default;
};

struct Transform {
  static constexpr const char* kName = "geometry_msgs/msg/Transform";
  Vector3 translation;
  Quaternion rotation;
  static void visit(auto& self, auto&& field) {
    field("translation", self.translation);
    field("rotation", self.rotation);
  }
  bool operator==(const Transform&) const = default;
};

struct TransformStamped {
  static constexpr const char* kName = "geometry_msgs/msg/TransformStamped";
  std_msgs::Header header;
  std::string child_frame_id;
  Transform transform;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("child_frame_id", self.child_frame_id);
    field("transform", self.transform);
  }
  bool operator==(const TransformStamped&) const = default;
};

struct Twist {
  static constexpr const char* kName = "geometry_msgs/msg/Twist";
  Vector3 linear;
  Vector3 angular;
  static void visit(auto& self, auto&& field) {
    field("linear", self.linear);
    field("angular", self.angular);
  }
  bool operator==(const Twist&) const = default;
};

struct TwistStamped {
  static constexpr const char* kName = "geometry_msgs/msg/TwistStamped";
  std_msgs::Header header;
  Twist twist;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("twist", self.twist);
  }
  bool operator==(const TwistStamped&) const = default;
};

struct TwistWithCovariance {
  static constexpr const char* kName = "geometry_msgs/msg/TwistWithCovariance";
  Twist twist;
  std::array<double, 36> covariance{};
  static void visit(auto& self, auto&& field) {
    field("twist", self.twist);
    field("covariance", self.covariance);
  }
  bool operator==(const TwistWithCovariance&) const = default;
};

struct TwistWithCovarianceStamped {
  static constexpr const char* kName = "geometry_msgs/msg/TwistWithCovarianceStamped";
  std_msgs::Header header;
  TwistWithCovariance twist;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("twist", self.twist);
  }
  bool operator==(const TwistWithCovarianceStamped&) const = default;
};

struct Wrench {
  static constexpr const char* kName = "geometry_msgs/msg/Wrench";
  Vector3 force;
  Vector3 torque;
  static void visit(auto& self, auto&& field) {
    field("force", self.force);
    field("torque", self.torque);
  }
  bool operator==(const Wrench&) const = default;
};

struct WrenchStamped {
  static constexpr const char* kName = "geometry_msgs/msg/WrenchStamped";
  std_msgs::Header header;
  Wrench wrench;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("wrench", self.wrench);
  }
  bool operator==(const WrenchStamped&) const = default;
};

struct Accel {
  static constexpr const char* kName = "geometry_msgs/msg/Accel";
  Vector3 linear;
  Vector3 angular;
  static void visit(auto& self, auto&& field) {
    field("linear", self.linear);
    field("angular", self.angular);
  }
  bool operator==(const Accel&) const = default;
};

}  // namespace pongsim::ros2::geometry_msgs
