#include "ign/closed_sockets.hh"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "ign/library.hh"
#include "pongsim/program/network_interface.hh"
#include "shared/sockets/senders.hh"

namespace pongsim::ign {

namespace {

/// SUBSCRIBERS_REQ and later ones. In front of the type are the packet's length, the version (a tag and a byte) and the
/// process's id (a tag, its length, 36 characters).
constexpr shared::RefusedKind kLaterKinds{.offset = 2 + 2 + 2 + 36, .tag = 4 << 3, .least = 8};

/// @return What a socket of discovery is bound to; nothing if it is none.
std::optional<in_addr> discoveryAddress(int handle) {
  int type = 0;
  socklen_t size = sizeof type;
  if (getsockopt(handle, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != SOCK_DGRAM) return std::nullopt;
  sockaddr_in bound{};
  size = sizeof bound;
  if (getsockname(handle, reinterpret_cast<sockaddr*>(&bound), &size) != 0 || bound.sin_family != AF_INET) {
    return std::nullopt;
  }
  const int port = ntohs(bound.sin_port);
  if (port != library().msgDiscPort && port != library().srvDiscPort) return std::nullopt;
  return bound.sin_addr;
}

/// @return The addresses of this machine: clients with default settings send from one of them.
shared::Senders ownSenders() {
  shared::Senders own;
  for (const NetworkInterface& each : networkInterfaces()) own.addresses.push_back(inet_addr(each.address.c_str()));
  own.addresses.resize(std::min(own.addresses.size(), shared::Senders::kMostAddresses));
  return own;
}

}  // namespace

int filterDiscovery(bool isOpen) {
  const shared::Senders senders = isOpen ? shared::Senders{.addresses = {}, .isAnybody = true} : ownSenders();
  int count = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const std::string name = entry.path().filename();
    int handle = -1;
    if (std::from_chars(name.data(), name.data() + name.size(), handle).ec != std::errc()) continue;
    const std::optional<in_addr> address = discoveryAddress(handle);
    if (!address) continue;
    // the socket of the heartbeats is bound to the group's address
    const bool isOfLibrary = address->s_addr == INADDR_ANY;
    if (shared::limitSenders(handle, senders, isOfLibrary ? std::optional(kLaterKinds) : std::nullopt)) ++count;
  }
  return count;
}

}  // namespace pongsim::ign
