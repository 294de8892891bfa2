#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/bulk.hh"
#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2::sensor_msgs {

struct LaserScan {
  static constexpr const char* kName = "sensor_msgs/msg/LaserScan";
  std_msgs::Header header;
  float angle_min = 0;
  float angle_max = 0;
  float angle_increment = 0;
  float time_increment = 0;
  float scan_time = 0;
  float range_min = 0;
  float range_max = 0;
  std::vector<float> ranges;
  std::vector<float> intensities;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("angle_min", self.angle_min);
    field("angle_max", self.angle_max);
    field("angle_increment", self.angle_increment);
    field("time_increment", self.time_increment);
    field("scan_time", self.scan_time);
    field("range_min", self.range_min);
    field("range_max", self.range_max);
    field("ranges", self.ranges);
    field("intensities", self.intensities);
  }
  bool operator==(const LaserScan&) const = default;
};

/// @param Bytes `BulkBytes` where the pixels go to the wire from where they are.
template <class Bytes>
struct BasicImage {
  static constexpr const char* kName = "sensor_msgs/msg/Image";
  std_msgs::Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string encoding;
  std::uint8_t is_bigendian = 0;
  std::uint32_t step = 0;
  Bytes data;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("height", self.height);
    field("width", self.width);
    field("encoding", self.encoding);
    field("is_bigendian", self.is_bigendian);
    field("step", self.step);
    field("data", self.data);
  }
  bool operator==(const BasicImage&) const = default;
};
using Image = BasicImage<std::vector<std::uint8_t>>;

}  // namespace pongsim::ros2::sensor_msgs
