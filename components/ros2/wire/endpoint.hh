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
  /// "RIHS01_..."; empty: not announced, as up to Humble.
  std::string typeHash;
  Qos qos;
  /// Whether a reader asks for messages within a time, or for a sign of life: our writers promise neither.
  bool hasDeadline = false;
  bool hasLiveliness = false;
  /// Of a service's endpoint, as others announce it: what rmw_cyclonedds calls the client or server that it belongs to.
  std::string cycloneId = {};
  bool operator==(const Contract&) const = default;
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
