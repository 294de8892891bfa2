#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

/// A node as others see it. Lists are sorted by name, then by type.
struct NodeInfo {
  /// A topic, service or action: "/scan", "sensor_msgs/msg/LaserScan".
  struct Way {
    std::string name;
    /// Empty if the type is not a ROS type.
    std::string type;
    auto operator<=>(const Way&) const = default;
  };
  /// "/robot"
  std::string nameSpace;
  /// "teleop"
  std::string name;
  std::vector<Way> publishes;
  std::vector<Way> subscribes;
  /// Without those of its actions; the same below.
  std::vector<Way> serves;
  std::vector<Way> calls;
  std::vector<Way> servesActions;
  std::vector<Way> callsActions;

  /// @return "/robot/teleop".
  std::string fullName() const;
};

/// Watches the nodes of a domain, as announced by their participants on `ros_discovery_info`. Any thread may use it;
/// must not outlive the participant.
class NodeWatch {
 public:
  explicit NodeWatch(Participant& participant);
  ~NodeWatch();
  NodeWatch(const NodeWatch&) = delete;
  NodeWatch& operator=(const NodeWatch&) = delete;

  /// Waits until no news has arrived for a while, up to `timeout`.
  void settle(std::chrono::nanoseconds timeout) const;

  /// @return The nodes of the other participants, sorted by full name.
  std::vector<NodeInfo> nodes() const;

 private:
  struct Told {
    std::string nameSpace;
    std::string name;
    std::vector<Guid> endpoints;
  };
  template <std::size_t GidSize>
  std::unique_ptr<Reader> makeReader();

  Participant& participant_;
  mutable std::mutex mutex_;
  /// The last announcement of each participant.
  std::map<Guid, std::vector<Told>> told_;
  std::uint64_t version_ = 0;
  std::unique_ptr<Reader> reader_;
};

}  // namespace pongsim::ros2
