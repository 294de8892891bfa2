#pragma once

#include <ignition/msgs/pointcloud_packed.pb.h>

#include <cstdint>
#include <span>

namespace pongsim {

/// Where a value of a point lies in it.
struct PointField {
  const char* name;
  std::uint32_t offset;
  ignition::msgs::PointCloudPacked::Field::DataType type;
};

/// Bytes of a point: Fortress puts what follows x, y and z behind 16 bytes, and fills them up to 32.
inline constexpr std::uint32_t kPointSize = 32;

/// Fills in what is the same in all clouds of a sensor, whose points are its bulk.
void beginCloud(std::span<const PointField> fields, std::uint32_t columns, std::uint32_t rows,
                ignition::msgs::PointCloudPacked& cloud);

}  // namespace pongsim
