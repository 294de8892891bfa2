#pragma once

#include <memory>

#include <nlohmann/json.hpp>

#include "web/rosbridge/ros_topics.hh"
#include "web/server/session.hh"

namespace pongsim::web::rosbridge {

/// Calls of one client: of the worlds' services, with pongsim's types as JSON, and of those of rosapi that tell of
/// topics and services. For the server's thread.
class Services {
 public:
  /// @param topics Must outlive it.
  Services(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, RosTopics& topics);

  /// Makes the service answer the client, or answers why it can't.
  /// @param request The client's `call_service`; not trusted.
  void call(const nlohmann::json& request);

 private:
  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  RosTopics& topics_;
};

}  // namespace pongsim::web::rosbridge
