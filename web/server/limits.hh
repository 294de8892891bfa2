#pragma once

#include <chrono>
#include <cstddef>

namespace pongsim::web {

/// What clients may ask of the server. Beyond it they are refused, with a word, and nobody else notices.
struct ServerLimits {
  /// Connections at a time, of browsers that load the page too.
  int connections = 512;
  /// WebSocket clients at a time.
  int clients = 256;
  /// The largest message that a client may send, all its pieces together.
  std::size_t messageBytes = std::size_t{4} << 20;
  /// What may wait for one client. Beyond it data is dropped, and a client is closed for which more than that waits of
  /// what must not be lost.
  std::size_t waitingBytes = std::size_t{32} << 20;
  /// Frames of data with a key of their own that wait for one client.
  std::size_t waitingKeys = 4096;
  /// Messages that must not be lost that wait for one client.
  std::size_t waitingMessages = 65536;
  /// How long a handshake may take, or an answer stay unread.
  std::chrono::seconds handshake{10};
  /// After so long without a word a client is asked whether it is still there, and closed where it does not answer as
  /// quickly as a handshake must be.
  std::chrono::seconds silence{30};
};

}  // namespace pongsim::web
