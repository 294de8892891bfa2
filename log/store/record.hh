#pragma once

#include <cstdint>
#include <string_view>

namespace pongsim::log {

/// A message as a log has it. What the views name lives as long as who hands it over says.
struct Record {
  /// When it was recorded [ns]: since the start of the simulation, or since 1970 where it was recorded by the clock of
  /// the wall. Of a log, either of the two.
  std::int64_t timeNs = 0;
  /// With its leading slash.
  std::string_view topic;
  /// Full name of its type: "ignition.msgs.Twist"; of ROS "geometry_msgs/msg/Twist".
  std::string_view type;
  /// In protobuf's binary form; of a type of ROS in CDR, with its header of four bytes.
  std::string_view payload;
};

}  // namespace pongsim::log
