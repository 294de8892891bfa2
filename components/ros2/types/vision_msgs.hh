#pragma once

#include <string>
#include <vector>

#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2::vision_msgs {

struct Point2D {
  static constexpr const char* kName = "vision_msgs/msg/Point2D";
  double x = 0;
  double y = 0;
  static void visit(auto& self, auto&& field) {
    field("x", self.x);
    field("y", self.y);
  }
  bool operator==(const Point2D&) const = default;
};

struct Pose2D {
  static constexpr const char* kName = "vision_msgs/msg/Pose2D";
  Point2D position;
  double theta = 0;
  static void visit(auto& self, auto&& field) {
    field("position", self.position);
    field("theta", self.theta);
  }
  bool operator==(const Pose2D&) const = default;
};

struct BoundingBox2D {
  static constexpr const char* kName = "vision_msgs/msg/BoundingBox2D";
  Pose2D center;
  double size_x = 0;
  double size_y = 0;
  static void visit(auto& self, auto&& field) {
    field("center", self.center);
    field("size_x", self.size_x);
    field("size_y", self.size_y);
  }
  bool operator==(const BoundingBox2D&) const = default;
};

struct ObjectHypothesis {
  static constexpr const char* kName = "vision_msgs/msg/ObjectHypothesis";
  std::string class_id;
  double score = 0;
  static void visit(auto& self, auto&& field) {
    field("class_id", self.class_id);
    field("score", self.score);
  }
  bool operator==(const ObjectHypothesis&) const = default;
};

struct ObjectHypothesisWithPose {
  static constexpr const char* kName = "vision_msgs/msg/ObjectHypothesisWithPose";
  ObjectHypothesis hypothesis;
  geometry_msgs::PoseWithCovariance pose;
  static void visit(auto& self, auto&& field) {
    field("hypothesis", self.hypothesis);
    field("pose", self.pose);
  }
  bool operator==(const ObjectHypothesisWithPose&) const = default;
};

struct Detection2D {
  static constexpr const char* kName = "vision_msgs/msg/Detection2D";
  std_msgs::Header header;
  std::vector<ObjectHypothesisWithPose> results;
  BoundingBox2D bbox;
  std::string id;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("results", self.results);
    field("bbox", self.bbox);
    field("id", self.id);
  }
  bool operator==(const Detection2D&) const = default;
};

struct Detection2DArray {
  static constexpr const char* kName = "vision_msgs/msg/Detection2DArray";
  std_msgs::Header header;
  std::vector<Detection2D> detections;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("detections", self.detections);
  }
  bool operator==(const Detection2DArray&) const = default;
};

struct BoundingBox3D {
  static constexpr const char* kName = "vision_msgs/msg/BoundingBox3D";
  geometry_msgs::Pose center;
  geometry_msgs::Vector3 size;
  static void visit(auto& self, auto&& field) {
    field("center", self.center);
    field("size", self.size);
  }
  bool operator==(const BoundingBox3D&) const = default;
};

struct Detection3D {
  static constexpr const char* kName = "vision_msgs/msg/Detection3D";
  std_msgs::Header header;
  std::vector<ObjectHypothesisWithPose> results;
  BoundingBox3D bbox;
  std::string id;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("results", self.results);
    field("bbox", self.bbox);
    field("id", self.id);
  }
  bool operator==(const Detection3D&) const = default;
};

struct Detection3DArray {
  static constexpr const char* kName = "vision_msgs/msg/Detection3DArray";
  std_msgs::Header header;
  std::vector<Detection3D> detections;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("detections", self.detections);
  }
  bool operator==(const Detection3DArray&) const = default;
};

}  // namespace pongsim::ros2::vision_msgs
