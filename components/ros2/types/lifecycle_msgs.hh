#pragma once

#include <cstdint>
#include <string>

#include "ros2/types/reflection.hh"

namespace pongsim::ros2::lifecycle_msgs {

struct State {
  static constexpr const char* kName = "lifecycle_msgs/msg/State";
  static constexpr std::uint8_t kPrimaryStateUnknown = 0;
  static constexpr std::uint8_t kPrimaryStateUnconfigured = 1;
  static constexpr std::uint8_t kPrimaryStateInactive = 2;
  static constexpr std::uint8_t kPrimaryStateActive = 3;
  static constexpr std::uint8_t kPrimaryStateFinalized = 4;
  std::uint8_t id = 0;
  std::string label;
  static void visit(auto& self, auto&& field) {
    field("id", self.id);
    field("label", self.label);
  }
  bool operator==(const State&) const = default;
};

}  // namespace pongsim::ros2::lifecycle_msgs
