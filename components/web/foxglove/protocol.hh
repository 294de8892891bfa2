#pragma once

#include <memory>
#include <string>
#include <vector>

#include "web/foxglove/log_channel.hh"
#include "web/foxglove/topic_channels.hh"
#include "web/foxglove/typed_channels.hh"
#include "web/server/session.hh"
#include "web/world/recent_log.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::foxglove {

/// Foxglove's WebSocket protocol, version 1, also used by Lichtblick and our own page. The page uses its own protocol
/// name, under which it is offered the own channels, and services that accept protobuf.
class FoxgloveProtocol final : public Protocol {
 public:
  /// @param own, log, assets Must outlive it.
  FoxgloveProtocol(std::shared_ptr<Worlds> worlds, const OwnChannels& own, RecentLog& log, const AssetSource& assets);
  ~FoxgloveProtocol() override;

  std::vector<std::string> names() const override;
  std::unique_ptr<Session> open(const std::string& name, const std::shared_ptr<Client>& client) override;

 private:
  const std::shared_ptr<Worlds> worlds_;
  const OwnChannels& own_;
  const AssetSource& assets_;
  TopicChannels topicChannels_;
  TypedChannels typed_;
  LogChannel log_;
};

}  // namespace pongsim::web::foxglove
