#include "web/server/handshakes.hh"

#include <algorithm>

namespace pongsim::web {

void Handshakes::add(lws* socket, Address peer) {
  remove(socket);
  places_[socket] = entries_.insert(entries_.end(), {socket, peer});
  ++counts_[peer];
}

void Handshakes::renew(lws* socket) {
  const auto place = places_.find(socket);
  if (place != places_.end()) entries_.splice(entries_.end(), entries_, place->second);
}

void Handshakes::remove(lws* socket) {
  const auto place = places_.find(socket);
  if (place == places_.end()) return;
  const auto count = counts_.find(place->second->peer);
  if (--count->second == 0) counts_.erase(count);
  entries_.erase(place->second);
  places_.erase(place);
}

std::size_t Handshakes::count(Address peer) const {
  const auto found = counts_.find(peer);
  return found == counts_.end() ? 0 : found->second;
}

lws* Handshakes::oldest() const { return entries_.empty() ? nullptr : entries_.front().socket; }

lws* Handshakes::oldest(Address peer) const {
  const auto found = std::ranges::find(entries_, peer, &Entry::peer);
  return found == entries_.end() ? nullptr : found->socket;
}

}  // namespace pongsim::web
