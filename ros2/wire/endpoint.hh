#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "ros2/types/bulk.hh"
#include "ros2/wire/guid.hh"
#include "ros2/wire/qos.hh"

namespace pongsim::ros2 {

/// What an endpoint tells its counterparts.
struct Contract {
  /// On the wire: "rt/scan".
  std::string topic;
  /// On the wire: "sensor_msgs::msg::dds_::LaserScan_".
  std::string type;
  /// "RIHS01_...", told where the distribution has it.
  std::string typeHash;
  Qos qos;
};

/// What has come.
struct Sample {
  /// CDR, encapsulation and all. There during the call only.
  std::span<const std::byte> payload;
  SampleId id;
  /// Of a request: its writer is where the reply goes to; of a reply: the request. Zeros where nothing is said.
  SampleId related;
};

}  // namespace pongsim::ros2
