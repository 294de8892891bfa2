#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "web/rosbridge/definition.hh"
#include "web/rosbridge/ros_topics.hh"
#include "web/server/session.hh"

namespace pongsim::web::rosbridge {

/// What one client publishes. For the server's thread. Functions get the client's request, which is not trusted, and
/// return what is wrong, as a sentence without a full stop, or an empty text.
class Publications {
 public:
  /// @param topics Must outlive it.
  Publications(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, RosTopics& topics);

  std::string advertise(const nlohmann::json& request);
  std::string unadvertise(const nlohmann::json& request);
  /// A topic that was not advertised is, if its type is known.
  std::string publish(const nlohmann::json& request);

 private:
  struct Publication {
    std::unique_ptr<TopicDecoder> decoder;
    RosDefinition definition;
    std::unique_ptr<RemotePublisher> publisher;
    /// The client's ids.
    std::set<std::string> ids;
  };

  std::string open(const std::string& name, const std::string& type);

  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  RosTopics& topics_;
  /// By topic.
  std::map<std::string, Publication, std::less<>> publications_;
};

}  // namespace pongsim::web::rosbridge
