#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "web/rosbridge/ros_topics.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::rosbridge {

/// The services of rosapi that tell of topics, services and the node
/// (https://github.com/RobotWebTools/rosbridge_suite/tree/ros2/rosapi). For the server's thread.
class Rosapi {
 public:
  /// @param topics Must outlive it, as must the worlds.
  /// @param mayWrite Whether services that change something are listed.
  Rosapi(RosTopics& topics, const Worlds& worlds, bool mayWrite)
      : topics_(topics), worlds_(worlds), mayWrite_(mayWrite) {}

  /// @return The response; nothing if there is no such service here.
  std::optional<nlohmann::json> call(const std::string& service, const nlohmann::json& arguments);

 private:
  nlohmann::json topics(bool withDefinitions);
  nlohmann::json topicsOf(const std::string& type);
  nlohmann::json services(const std::optional<std::string>& type);
  nlohmann::json nodeDetails(const std::string& node);
  nlohmann::json time();

  RosTopics& topics_;
  const Worlds& worlds_;
  const bool mayWrite_;
};

}  // namespace pongsim::web::rosbridge
