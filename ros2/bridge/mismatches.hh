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

/// A topic of ROS as it is bridged here.
struct Offer {
  /// "/scan"
  std::string ros;
  /// The simulation's: "/lidar".
  std::string ignition;
  const Pair* pair = nullptr;
  /// Of the writer and the reader that are here, if they are.
  std::optional<Qos> writer = std::nullopt;
  std::optional<Qos> reader = std::nullopt;
};

/// @return Why another node's endpoint never meets the offer, though it is of the same topic: another type, or a
/// quality of service that does not match the one here. Nothing where they meet, or have nothing to do with each
/// other.
std::optional<std::string> mismatch(const Offer& offer, const Graph::Endpoint& theirs);

/// Warns of endpoints that other nodes have on bridged topics and that never meet: DDS itself says nothing. Once for
/// each endpoint. For the simulation's thread.
class Mismatches {
 public:
  explicit Mismatches(RosNode& ros) : ros_(ros) {}

  /// To be called in each step; cheap where nothing has changed.
  /// @param offersVersion A number that is another one when the offers are others.
  /// @param offers Asked for only where something has changed.
  void update(std::uint64_t offersVersion, const std::function<std::vector<Offer>()>& offers);

 private:
  RosNode& ros_;
  std::uint64_t offersVersion_ = 0;
  std::uint64_t seenVersion_ = 0;
  std::uint64_t checkedVersion_ = 0;
  std::set<Guid> warned_;
};

}  // namespace pongsim::ros2
