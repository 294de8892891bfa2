#pragma once

#include <string>

#include "ros2/types/builtin_interfaces.hh"

namespace pongsim::ros2::std_msgs {

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

struct Empty {
  static constexpr const char* kName = "std_msgs/msg/Empty";
  static void visit(auto&, auto&&) {}
  bool operator==(const Empty&) const = default;
};

struct String {
  static constexpr const char* kName = "std_msgs/msg/String";
  std::string data;
  static void visit(auto& self, auto&& field) { field("data", self.data); }
  bool operator==(const String&) const = default;
};

}  // namespace pongsim::ros2::std_msgs
