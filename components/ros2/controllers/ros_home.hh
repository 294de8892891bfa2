#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ros2/config/settings.hh"
#include "ros2/node/node.hh"
#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

/// What the system that makes the simulation a ROS node shares with the systems of models, which have nodes of their
/// own beside it. Whoever uses it keeps it, because the systems end in any order.
struct RosHome {
  Settings settings;
  std::optional<Participant> participant;
  std::optional<RosNode> node;
  /// Whether the robots' frames are published on /tf.
  bool tellsTransforms = true;
  /// The full names of the robots' controller managers.
  std::multiset<std::string> managers;

  /// Sets the topics that an owner publishes instead of the node.
  void replace(const void* owner, std::vector<std::string> topics) {
    std::vector<std::string>& known = replaced_[owner];
    if (known == topics) return;
    known = std::move(topics);
    ++version_;
  }
  std::set<std::string> replaced() const {
    std::set<std::string> all;
    for (const auto& [owner, topics] : replaced_) all.insert(topics.begin(), topics.end());
    return all;
  }
  /// Changes with `replaced`.
  std::uint64_t version() const { return version_; }

 private:
  std::map<const void*, std::vector<std::string>> replaced_;
  std::uint64_t version_ = 0;
};

/// The system that has it, for systems of models that find it by `SystemContext::before`.
class RosHost {
 public:
  virtual ~RosHost() = default;
  virtual std::shared_ptr<RosHome> home() const = 0;
};

}  // namespace pongsim::ros2
