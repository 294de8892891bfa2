#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/builtin_interfaces.hh"

namespace pongsim::ros2::std_msgs {

struct Bool {
  static constexpr const char* kName = "std_msgs/msg/Bool";
  bool data = false;
  static void visit(auto& self, auto&& field) { field("data", self.data); }
  bool operator==(const Bool&) const = default;
};

struct ColorRGBA {
  static constexpr const char* kName = "std_msgs/msg/ColorRGBA";
  float r = 0;
  float g = 0;
  float b = 0;
  float a = 0;
  static void visit(auto& self, auto&& field) {
    field("r", self.r);
    field("g", self.g);
    field("b", self.b);
    field("a", self.a);
  }
  bool operator==(const ColorRGBA&) const = default;
};

struct Empty {
  static constexpr const char* kName = "std_msgs/msg/Empty";
  static void visit(auto&, auto&&) {}
  bool operator==(const Empty&) const = default;
};

struct Float32 {
  static constexpr const char* kName = "std_msgs/msg/Float32";
  float data = 0;
  static void visit(auto& self, auto&& field) { field("data", self.data); }
  bool operator==(const Float32&) const = default;
};

struct Float64 {
  static constexpr const char* kName = "std_msgs/msg/Float64";
  double data = 0;
  static void visit(auto& self, auto&& field) { field("data", self.data); }
  bool operator==(const Float64&) const = default;
};

struct Header {
  static constexpr const char* kName = "std_msgs/msg/Header";
  builtin_interfaces::Time stamp;
  std::string frame_id;
  static void visit(auto& self, auto&& field) {
    field("stamp", self.stamp);
    field("frame_id", self.frame_id);
  }
  bool operator==(const Header&) const = default;
};

struct Int32 {
  static constexpr const char* kName = "std_msgs/msg/Int32";
  std::int32_t data = 0;
  static void visit(auto& self, auto&& field) { field("data", self.data); }
  bool operator==(const Int32&) const = default;
};

struct UInt32 {
  static constexpr const char* kName = "std_msgs/msg/UInt32";
  std::uint32_t data = 0;
  static void visit(auto& self, auto&& field) { field("data", self.data); }
  bool operator==(const UInt32&) const = default;
};

struct String {
  static constexpr const char* kName = "std_msgs/msg/String";
  std::string data;
  static void visit(auto& self, auto&& field) { field("data", self.data); }
  bool operator==(const String&) const = default;
};

struct MultiArrayDimension {
  static constexpr const char* kName = "std_msgs/msg/MultiArrayDimension";
  std::string label;
  std::uint32_t size = 0;
  std::uint32_t stride = 0;
  static void visit(auto& self, auto&& field) {
    field("label", self.label);
    field("size", self.size);
    field("stride", self.stride);
  }
  bool operator==(const MultiArrayDimension&) const = default;
};

struct MultiArrayLayout {
  static constexpr const char* kName = "std_msgs/msg/MultiArrayLayout";
  std::vector<MultiArrayDimension> dim;
  std::uint32_t data_offset = 0;
  static void visit(auto& self, auto&& field) {
    field("dim", self.dim);
    field("data_offset", self.data_offset);
  }
  bool operator==(const MultiArrayLayout&) const = default;
};

struct Float64MultiArray {
  static constexpr const char* kName = "std_msgs/msg/Float64MultiArray";
  MultiArrayLayout layout;
  std::vector<double> data;
  static void visit(auto& self, auto&& field) {
    field("layout", self.layout);
    field("data", self.data);
  }
  bool operator==(const Float64MultiArray&) const = default;
};

}  // namespace pongsim::ros2::std_msgs
