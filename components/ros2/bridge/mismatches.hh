#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ros2/node/node.hh"
#include "ros2/pairs/pair.hh"
#include "ros2/wire/graph.hh"

namespace pongsim::ros2 {

/// A bridged ROS topic.
struct Offer {
  /// "/scan"
  std::string ros;
  /// Name in the simulation: "/lidar".
  std::string ignition;
  const Pair* pair = nullptr;
  /// Of our writer and reader, if they exist.
  std::optional<Qos> writer = std::nullopt;
  std::optional<Qos> reader = std::nullopt;
};

/// @return Why another node's endpoint can't connect to the offer although it has the same topic: another type, or an
/// incompatible quality of service. Nothing if they connect, or are unrelated.
std::optional<std::string> mismatch(const Offer& offer, const Graph::Endpoint& theirs);

/// Warns about other nodes' endpoints on bridged topics that can't connect, because DDS itself reports nothing. Once
/// for each endpoint. For the simulation's thread.
class Mismatches {
 public:
  explicit Mismatches(RosNode& ros) : ros_(ros) {}

  /// Call in each step; cheap if nothing has changed.
  /// @param offersVersion A number that changes when the offers change.
  /// @param offers Only called if something has changed.
  void update(std::uint64_t offersVersion, const std::function<std::vector<Offer>()>& offers);

 private:
  RosNode& ros_;
  std::uint64_t offersVersion_ = 0;
  std::uint64_t seenVersion_ = 0;
  std::uint64_t checkedVersion_ = 0;
  std::set<Guid> warned_;
};

}  // namespace pongsim::ros2
