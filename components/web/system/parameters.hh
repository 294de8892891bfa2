#pragma once

#include <string>
#include <vector>

#include "pongsim/declaration.hh"
#include "pongsim/element.hh"
#include "web/gz/settings.hh"
#include "web/server/server.hh"

namespace pongsim::web {

/// The content of the `<plugin>`, for our own system and as ign-launch's WebSocket server.
struct WebParameters {
  int port = 9002;
  std::vector<std::string> origins;
  std::vector<std::string> writingOrigins;
  std::vector<std::string> framingOrigins;
  bool isReadOnly = false;
  std::string certificate;
  std::string key;
  GzSettings gz;

  /// Binds the members, so this must not be moved.
  void declare(Declaration& declaration);

  /// Reads what `declare` does not.
  /// @throws Error with the position of what is invalid.
  void readRest(const Element& plugin);
};

/// @param network A network interface by name or IPv4 address; empty: this machine only.
/// @param token Set by the user; if empty, one is created when other machines can reach the server.
/// @return The server's settings, except for the page and the files of worlds.
/// @throws std::runtime_error if there is no such interface.
ServerSettings serverSettings(const WebParameters& parameters, const std::string& network, const std::string& token);

/// @return The addresses to open in a browser, without and with the token: "http://192.0.2.7:9002/?token=...".
std::string pageAddress(const ServerSettings& settings, int port);

}  // namespace pongsim::web
