#pragma once

#include <string>
#include <vector>

#include "pongsim/declaration.hh"
#include "pongsim/element.hh"
#include "web/gz/settings.hh"
#include "web/server/server.hh"

namespace pongsim::web {

/// What stands below the `<plugin>`, for the system as ours and as ign-launch's WebSocket server.
struct WebParameters {
  int port = 9002;
  std::vector<std::string> origins;
  std::vector<std::string> writingOrigins;
  bool isReadOnly = false;
  std::string certificate;
  std::string key;
  GzSettings gz;

  /// Binds the members, which must stay where they are.
  void declare(Declaration& declaration);

  /// Reads what `declare` does not.
  /// @throws Error naming the position of what can't be used.
  void readRest(const Element& plugin);
};

/// @param network A network interface by name or IPv4 address; empty: this machine only.
/// @param token Of the user; empty: one is made where other machines reach the server.
/// @return What the server is to be made with, without the page and the files of worlds.
/// @throws std::runtime_error where there is no such interface.
ServerSettings serverSettings(const WebParameters& parameters, const std::string& network, const std::string& token);

/// @return What to open in a browser, without and with the token: "http://192.0.2.7:9002/?token=...".
std::string pageAddress(const ServerSettings& settings, int port);

}  // namespace pongsim::web
