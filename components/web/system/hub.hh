#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "pongsim/log.hh"
#include "web/assets/assets.hh"
#include "web/foxglove/protocol.hh"
#include "web/frames/channel_list.hh"
#include "web/gz/protocol.hh"
#include "web/gz/settings.hh"
#include "web/server/server.hh"
#include "web/system/plain_protocol.hh"
#include "web/world/recent_log.hh"
#include "web/world/worlds.hh"

namespace pongsim::web {

/// Shared by the worlds of a process: the server, the protocols, and the worlds as these see them. For any thread.
class Hub {
 public:
  /// @return The hub on this port, created if there is none yet; port 0 matches any hub.
  /// @throws std::runtime_error if the server can't start, or is already running with other settings.
  static std::shared_ptr<Hub> open(const ServerSettings& settings, const GzSettings& gz);

  Hub(ServerSettings settings, const GzSettings& gz);
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  const std::shared_ptr<Worlds>& worlds() { return worlds_; }
  ChannelList& channels() { return channels_; }
  Assets& assets() { return assets_; }
  const Server& server() const { return *server_; }
  const ServerSettings& settings() const { return settings_; }

 private:
  Logger log_{"web"};
  ServerSettings settings_;
  const GzSettings gzSettings_;
  const std::shared_ptr<Worlds> worlds_ = std::make_shared<Worlds>();
  ChannelList channels_;
  Assets assets_;
  RecentLog recentLog_;
  foxglove::FoxgloveProtocol foxglove_{worlds_, channels_, recentLog_, assets_};
  gz::GzProtocol gz_;
  PlainProtocol plain_;
  // last, because its thread uses the members above
  std::optional<Server> server_;
};

/// @return The folder of the installed page; empty if there is none.
std::filesystem::path installedPage();

}  // namespace pongsim::web
