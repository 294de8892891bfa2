#pragma once

#include <cstdint>

#include "ros2/types/reflection.hh"

namespace pongsim::ros2::builtin_interfaces {

struct Time {
  static constexpr const char* kName = "builtin_interfaces/msg/Time";
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  static void visit(auto& self, auto&& field) {
    field("sec", self.sec);
    field("nanosec", self.nanosec);
  }
  bool operator==(const Time&) const = default;
};

struct Duration {
  static constexpr const char* kName = "builtin_interfaces/msg/Duration";
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  static void visit(auto& self, auto&& field) {
    field("sec", self.sec);
    field("nanosec", self.nanosec);
  }
  bool operator==(const Duration&) const = default;
};

}  // namespace pongsim::ros2::builtin_interfaces
