#pragma once

#include <map>
#include <string>

namespace pongsim::web {

/// The parameters of ign-launch's WebSocket server.
struct GzSettings {
  /// Maximum number of messages of a topic that a client gets per second of wall time, positive.
  double publicationHz = 60;
  /// Keys with which clients authenticate (`auth`), if one is set; either gives full access.
  std::string authorizationKey;
  std::string adminAuthorizationKey;
  /// Concurrent clients; negative: as many as the server allows.
  int maxConnections = -1;
  /// Maximum number of messages queued for a subscription; negative: depends on its type.
  int queueSizePerConnection = -1;
  /// How many topics of a type a client can subscribe to.
  std::map<std::string, int> subscriptionLimits;
  bool operator==(const GzSettings&) const = default;
};

}  // namespace pongsim::web
