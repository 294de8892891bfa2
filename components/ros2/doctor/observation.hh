#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ros2/node/node_watch.hh"
#include "ros2/wire/graph.hh"

namespace pongsim::ros2 {

/// Stamps of messages, in the order in which they came [s].
struct Stamps {
  std::size_t count = 0;
  double first = 0;
  double last = 0;
  bool goBack = false;

  void add(double stamp) {
    if (count == 0) first = stamp;
    goBack |= count > 0 && stamp < last;
    last = stamp;
    ++count;
  }
  /// @return Messages per second of their stamps; nothing if there are not enough for that.
  std::optional<double> rate() const {
    if (count < 3 || last <= first) return std::nullopt;
    return static_cast<double>(count - 1) / (last - first);
  }
};

/// The messages on a topic whose type has a header.
struct StreamSeen {
  /// "sensor_msgs/msg/LaserScan"
  std::string type;
  Stamps stamps = {};
  std::set<std::string> frames = {};
  /// Of odometry: `child_frame_id`.
  std::set<std::string> childFrames = {};
  /// Of joint states: the joints.
  std::set<std::string> joints = {};
  /// Whether all variances are zero, or said to be unknown.
  bool lacksVariances = false;
};

/// A frame on /tf or /tf_static.
struct FrameSeen {
  std::set<std::string> parents = {};
  std::set<Guid> publishers = {};
  bool isStatic = false;
  Stamps stamps = {};
};

/// What a domain's nodes did while it was watched.
struct Observation {
  Stamps clock = {};
  /// By topic.
  std::map<std::string, StreamSeen> streams = {};
  /// By name.
  std::map<std::string, FrameSeen> frames = {};
  /// URDF texts by topic.
  std::map<std::string, std::string> descriptions = {};
  std::vector<Graph::Endpoint> endpoints = {};
  std::vector<NodeInfo> nodes = {};
  /// Nodes whose parameter `use_sim_time` is false.
  std::vector<std::string> onWallTime = {};

  /// @param topic In ROS: "/scan".
  std::vector<Graph::Endpoint> endpointsOn(const std::string& topic, Graph::Role role) const;
  /// @return The topics that have writers of a type, "sensor_msgs/msg/LaserScan", sorted.
  std::vector<std::string> topicsOf(const std::string& type) const;
  /// @return Their full names, separated by ", ".
  std::string nodesThat(const std::vector<NodeInfo::Interface> NodeInfo::*use, const std::string& topic) const;
};

}  // namespace pongsim::ros2
