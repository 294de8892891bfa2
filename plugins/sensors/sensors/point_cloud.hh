#pragma once

#include <ignition/msgs/pointcloud_packed.pb.h>

#include <cstdint>
#include <span>

namespace pongsim {

/// Offsets of a point's values.
struct PointField {
  const char* name;
  std::uint32_t offset;
  ignition::msgs::PointCloudPacked::Field::DataType type;
};

/// Bytes per point: Fortress pads x, y and z to 16 bytes, and the rest to 32.
inline constexpr std::uint32_t kPointSize = 32;

/// Fills in what is the same in all clouds of a sensor. The points are its bulk.
void beginCloud(std::span<const PointField> fields, std::uint32_t columns, std::uint32_t rows,
                ignition::msgs::PointCloudPacked& cloud);

}  // namespace pongsim
