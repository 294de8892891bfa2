#pragma once

#include <cstdint>
#include <string_view>

namespace pongsim::log {

/// A message in a log. How long its data is valid depends on where it comes from.
struct Record {
  /// Time of recording [ns]: since the start of the simulation, or since 1970 if recorded in wall time. All records of
  /// a log use the same one.
  std::int64_t timeNs = 0;
  /// With its leading slash.
  std::string_view topic;
  /// Full name of its type: "ignition.msgs.Twist", or for ROS "geometry_msgs/msg/Twist".
  std::string_view type;
  /// In protobuf's binary format; for ROS types in CDR, with its four-byte header.
  std::string_view payload;
};

}  // namespace pongsim::log
