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
  struct Interface {
    std::string name;
    /// Empty if the type is not a ROS type.
    std::string type;
    auto operator<=>(const Interface&) const = default;
  };
  /// "/robot"
  std::string nameSpace;
  /// "teleop"
  std::string name;
  std::vector<Interface> publishes;
  std::vector<Interface> subscribes;
  /// Without those of its actions; the same below.
  std::vector<Interface> serves;
  std::vector<Interface> calls;
  std::vector<Interface> servesActions;
  std::vector<Interface> callsActions;

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

  /// Waits until nothing has been announced for 0.7 s, up to `timeout`.
  void settle(std::chrono::nanoseconds timeout) const;

  /// @return The nodes of the other participants, sorted by full name.
  std::vector<NodeInfo> nodes() const;

 private:
  struct Announced {
    std::string nameSpace;
    std::string name;
    std::vector<Guid> endpoints;
  };
  template <std::size_t GidSize>
  void receive(const Sample& sample);

  Participant& participant_;
  mutable std::mutex mutex_;
  /// The last announcement of each participant.
  std::map<Guid, std::vector<Announced>> announced_;
  std::uint64_t version_ = 0;
  std::unique_ptr<Reader> reader_;
};

}  // namespace pongsim::ros2
