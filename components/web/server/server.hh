#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/log.hh"
#include "web/server/access.hh"
#include "web/server/limits.hh"
#include "web/server/session.hh"
#include "web/server/traffic.hh"

namespace pongsim::web {

/// @param address The requested path after "/assets": "/home/me/model/meshes/arm.dae".
/// @return The file if the world uses it, else nothing. For any thread.
using FindAsset = std::function<std::optional<std::filesystem::path>(std::string_view address)>;

struct ServerSettings {
  /// Addresses of this machine, IPv4.
  std::vector<std::string> addresses{"127.0.0.1"};
  /// 0: any free port.
  int port = 9002;
  AccessRules access;
  /// Origins of pages that may show the page in a frame; with ":*" for any port: "http://localhost:*".
  std::vector<std::string> framingOrigins;
  /// Files of the page; empty: none.
  std::filesystem::path page;
  FindAsset findAsset;
  /// In PEM, both or neither.
  std::filesystem::path certificate;
  std::filesystem::path key;
  ServerLimits limits;
  /// Where clients and what they have been sent are listed.
  std::shared_ptr<TrafficBook> traffic = std::make_shared<TrafficBook>();
};

/// HTTP and WebSocket server on one port, with or without TLS, with its own thread.
class Server {
 public:
  /// @param log Must outlive it.
  /// @param protocols Create the sessions. Must outlive it.
  /// @throws std::runtime_error if the port is not available or the certificate is unusable.
  Server(ServerSettings settings, const Logger& log, const std::vector<Protocol*>& protocols);
  /// Closes all connections.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  int port() const;
  /// @return Number of WebSocket clients.
  std::size_t clients() const;

 private:
  class Loop;
  std::unique_ptr<Loop> loop_;
};

}  // namespace pongsim::web
