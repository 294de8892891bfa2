#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "web/foxglove/topic_channels.hh"
#include "web/foxglove/wire.hh"
#include "web/server/session.hh"
#include "web/world/message_form.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::foxglove {

/// The services advertised to one client, and its calls. For the server's thread.
class ServiceCalls {
 public:
  /// @param channels Must outlive it.
  /// @param form The encoding that services advertise: Foxglove only calls those that accept JSON. Calls in
  /// either form are accepted.
  ServiceCalls(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, TopicChannels& channels,
               MessageForm form);

  /// Advertises added services to the client, and removes the others. A read-only client only sees services that change
  /// nothing.
  void follow();

  /// Makes the service answer the client, or reports why it can't.
  void call(const ServiceCall& call);

 private:
  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  TopicChannels& topicChannels_;
  const MessageForm form_;
  std::uint32_t nextService_ = 1;
  /// Keyed by id.
  std::map<std::uint32_t, Worlds::ServicePlace> services_;
};

}  // namespace pongsim::web::foxglove
