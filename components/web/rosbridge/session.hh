#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "web/rosbridge/publications.hh"
#include "web/rosbridge/ros_topics.hh"
#include "web/rosbridge/services.hh"
#include "web/rosbridge/subscriptions.hh"
#include "web/server/session.hh"

namespace pongsim::web::rosbridge {

/// A client that speaks rosbridge's protocol, version 2
/// (https://github.com/RobotWebTools/rosbridge_suite/blob/ros2/ROSBRIDGE_PROTOCOL.md).
class RosbridgeSession final : public Session {
 public:
  /// @param topics Must outlive it.
  RosbridgeSession(std::shared_ptr<Client> client, const std::shared_ptr<Worlds>& worlds, RosTopics& topics);
  ~RosbridgeSession() override;
  RosbridgeSession(const RosbridgeSession&) = delete;
  RosbridgeSession& operator=(const RosbridgeSession&) = delete;

  void text(std::string_view message) override;
  void binary(std::span<const std::byte> message) override;

 private:
  /// What runs when the topics of a world have changed.
  struct State;

  const std::shared_ptr<State> state_;
  std::shared_ptr<void> watch_;
};

/// @return Whether a client's first message is of this protocol, and not of that of Gazebo's server.
bool isRosbridge(std::string_view message);

}  // namespace pongsim::web::rosbridge
