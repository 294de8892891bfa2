#pragma once

#include <string>
#include <string_view>

#include "ros2/types/type_description.hh"

namespace pongsim::ros2 {

/// What peers are told of a type.
struct TypeInfo {
  /// "sensor_msgs/msg/LaserScan"
  std::string name;
  /// "RIHS01_..."
  std::string hash;
};

TypeInfo typeInfo(const TypeDescription& type);

template <Structure Type>
TypeInfo typeInfo() {
  return typeInfo(typeDescription<Type>());
}

/// @return The name on the wire: "sensor_msgs::msg::dds_::LaserScan_".
std::string ddsTypeName(std::string_view name);

/// @return Of "sensor_msgs::msg::dds_::LaserScan_" "sensor_msgs/msg/LaserScan"; empty where it is no such name.
std::string rosTypeName(std::string_view ddsName);

}  // namespace pongsim::ros2
