#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "ros2/types/bulk.hh"
#include "ros2/wire/guid.hh"
#include "ros2/wire/qos.hh"

namespace pongsim::ros2 {

/// What an endpoint announces to its counterparts.
struct Contract {
  /// On the wire: "rt/scan".
  std::string topic;
  /// On the wire: "sensor_msgs::msg::dds_::LaserScan_".
  std::string type;
  /// "RIHS01_...", announced if the distribution uses it.
  std::string typeHash;
  Qos qos;
};

/// A received sample.
struct Sample {
  /// CDR including the encapsulation. Only valid during the call.
  std::span<const std::byte> payload;
  SampleId id;
  /// For a request: its writer tells where the reply goes; for a reply: the request. Zeros if unknown.
  SampleId related;
};

}  // namespace pongsim::ros2
