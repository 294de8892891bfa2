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
#include "web/world/heard_log.hh"
#include "web/world/worlds.hh"

namespace pongsim::web {

/// What the worlds of a process share: the server, the protocols and what these see of the worlds. For any thread.
class Hub {
 public:
  /// @return The one on that port, which is made where there is none yet; that of port 0 is anybody's.
  /// @throws std::runtime_error where the server can't be had, or is there with other settings.
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
  HeardLog heardLog_;
  foxglove::FoxgloveProtocol foxglove_{worlds_, channels_, heardLog_, assets_};
  gz::GzProtocol gz_;
  // begins last
  std::optional<Server> server_;
};

/// @return The folder of the page that is installed with this; empty where there is none.
std::filesystem::path installedPage();

}  // namespace pongsim::web
