#pragma once

#include <array>
#include <cstdint>

#include "ros2/types/reflection.hh"

namespace pongsim::ros2::unique_identifier_msgs {

struct UUID {
  static constexpr const char* kName = "unique_identifier_msgs/msg/UUID";
  std::array<std::uint8_t, 16> uuid{};
  static void visit(auto& self, auto&& field) { field("uuid", self.uuid); }
  bool operator==(const UUID&) const = default;
};

}  // namespace pongsim::ros2::unique_identifier_msgs
