#pragma once

#include <chrono>
#include <cstddef>

namespace pongsim::web {

/// Limits on what clients can request. Beyond them they are refused, with a message, and nobody else is affected.
struct ServerLimits {
  /// Concurrent connections, including browsers that load the page.
  int connections = 512;
  /// Concurrent connections from one address that are not WebSocket clients. A further one takes the place of the
  /// oldest.
  std::size_t handshakesOfAPeer = 128;
  /// Concurrent WebSocket clients.
  int clients = 256;
  /// Maximum size of a client's message, all fragments together.
  std::size_t messageBytes = std::size_t{4} << 20;
  /// Maximum size of what is queued for one client. Beyond it, data is dropped; a client is closed if this much that
  /// must not be lost is queued.
  std::size_t waitingBytes = std::size_t{32} << 20;
  /// Maximum number of keys with data frames queued for one client.
  std::size_t waitingKeys = 4096;
  /// Maximum number of messages that must not be lost queued for one client.
  std::size_t waitingMessages = 65536;
  /// Timeout for a handshake, and for a reply that is not read.
  std::chrono::seconds handshake{10};
  /// After this long without a message, a client is asked whether it is still there, and closed if it does not answer
  /// within the handshake timeout.
  std::chrono::seconds silence{30};
};

}  // namespace pongsim::web
