#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <unordered_map>

struct lws;

namespace pongsim::web {

/// Connections that are not WebSocket clients, or not yet: slow or unfinished handshakes, and requests for files. The
/// one that has been waiting longest makes room for a new one, so nobody can keep others out by opening many.
class Handshakes {
 public:
  /// A peer's IPv4 address.
  using Address = std::uint32_t;

  void add(lws* socket, Address peer);
  /// The connection has sent a request: it becomes the youngest.
  void renew(lws* socket);
  void remove(lws* socket);

  std::size_t count(Address peer) const;
  /// @return The connection that has been waiting longest; null if there is none.
  lws* oldest() const;
  /// @return That of this peer.
  lws* oldest(Address peer) const;

 private:
  struct Entry {
    lws* socket = nullptr;
    Address peer = 0;
  };

  /// The oldest first.
  std::list<Entry> entries_;
  std::unordered_map<lws*, std::list<Entry>::iterator> places_;
  std::unordered_map<Address, std::size_t> counts_;
};

}  // namespace pongsim::web
