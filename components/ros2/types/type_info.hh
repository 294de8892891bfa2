#pragma once

#include <string>
#include <string_view>

#include "ros2/types/type_description.hh"

namespace pongsim::ros2 {

/// How a type is announced to peers.
struct TypeInfo {
  /// "sensor_msgs/msg/LaserScan"
  std::string name;
  /// "RIHS01_..."
  std::string hash;
  TypeDescription (*describe)() = nullptr;
};

TypeInfo typeInfo(const TypeDescription& type);

template <Structure Type>
TypeInfo typeInfo() {
  TypeInfo info = typeInfo(typeDescription<Type>());
  info.describe = typeDescription<Type>;
  return info;
}

/// @return The name on the wire: "sensor_msgs::msg::dds_::LaserScan_".
std::string ddsTypeName(std::string_view name);

/// @return "sensor_msgs/msg/LaserScan" for "sensor_msgs::msg::dds_::LaserScan_"; empty for other names.
std::string rosTypeName(std::string_view ddsName);

}  // namespace pongsim::ros2
