#include "ign/closed_sockets.hh"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string>
#include <system_error>

#include "ign/library.hh"
#include "pongsim/program/network_interface.hh"
#include "shared/sockets/senders.hh"

namespace pongsim::ign {

namespace {

bool isDiscovery(int handle) {
  int type = 0;
  socklen_t size = sizeof type;
  if (getsockopt(handle, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != SOCK_DGRAM) return false;
  sockaddr_in bound{};
  size = sizeof bound;
  if (getsockname(handle, reinterpret_cast<sockaddr*>(&bound), &size) != 0 || bound.sin_family != AF_INET) return false;
  const int port = ntohs(bound.sin_port);
  return port == library().msgDiscPort || port == library().srvDiscPort;
}

/// @return The addresses of this machine: clients with default settings send from one of them.
shared::Senders ownSenders() {
  shared::Senders own;
  for (const NetworkInterface& each : networkInterfaces()) own.addresses.push_back(inet_addr(each.address.c_str()));
  own.addresses.resize(std::min(own.addresses.size(), shared::Senders::kMostAddresses));
  return own;
}

}  // namespace

int closeDiscoveryToOthers() {
  const shared::Senders own = ownSenders();
  int count = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const std::string name = entry.path().filename();
    int handle = -1;
    if (std::from_chars(name.data(), name.data() + name.size(), handle).ec != std::errc()) continue;
    if (isDiscovery(handle) && shared::limitSenders(handle, own)) ++count;
  }
  return count;
}

}  // namespace pongsim::ign
