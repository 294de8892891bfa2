#pragma once

#include <map>
#include <string>

namespace pongsim::web {

/// The parameters of ign-launch's WebSocket server.
struct GzSettings {
  /// How many messages of a topic a client gets a second of wall time at most, above 0.
  double publicationHz = 60;
  /// Keys by which clients say that they may come in (`auth`), where one is set; both let in to everything.
  std::string authorizationKey;
  std::string adminAuthorizationKey;
  /// Clients at a time; below 0: as many as the server takes.
  int maxConnections = -1;
  /// Messages of one subscription that wait for a client at most; below 0: as many as suit its type.
  int queueSizePerConnection = -1;
  /// How many topics of a type a client may listen to.
  std::map<std::string, int> subscriptionLimits;
};

}  // namespace pongsim::web
