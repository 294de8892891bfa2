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

namespace pongsim::web {

/// @param address What stands behind "/assets" in what was asked for: "/home/me/model/meshes/arm.dae".
/// @return The file, where the world needs it; nothing where it is none of its business. For any thread.
using FindAsset = std::function<std::optional<std::filesystem::path>(std::string_view address)>;

struct ServerSettings {
  /// Of this machine, IPv4.
  std::vector<std::string> addresses{"127.0.0.1"};
  /// 0: any that is free.
  int port = 9002;
  AccessRules access;
  /// Files of the page; empty: there is none.
  std::filesystem::path page;
  FindAsset findAsset;
  /// In PEM, both or neither.
  std::filesystem::path certificate;
  std::filesystem::path key;
  ServerLimits limits;
};

/// HTTP and WebSocket on one port, with or without TLS, on a thread of its own.
class Server {
 public:
  /// @param log Must outlive it.
  /// @param protocols Sessions are opened by. Must outlive it.
  /// @throws std::runtime_error where the port can't be had or the certificate can't be used.
  Server(ServerSettings settings, const Logger& log, const std::vector<Protocol*>& protocols);
  /// Closes all connections.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  int port() const;
  /// @return How many WebSocket clients there are.
  std::size_t clients() const;

 private:
  class Loop;
  std::unique_ptr<Loop> loop_;
};

}  // namespace pongsim::web
