#include "ros2/wire/local_sockets.hh"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

namespace pongsim::ros2 {

namespace {

// The kernel limits it to net.core.rmem_max and wmem_max: an image needs room for all of its packets at once.
constexpr int kSocketBuffer = 4 << 20;

template <class Value>
bool set(const UdpSocket& socket, int level, int name, const Value& value) {
  return setsockopt(socket.handle(), level, name, &value, sizeof value) == 0;
}

UdpSocket open() {
  UdpSocket socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket) return socket;
  set(socket, SOL_SOCKET, SO_RCVBUF, kSocketBuffer);
  set(socket, SOL_SOCKET, SO_SNDBUF, kSocketBuffer);
  return socket;
}

bool bindTo(const UdpSocket& socket, std::uint32_t address, std::uint16_t port) {
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_addr.s_addr = address;
  name.sin_port = htons(port);
  return bind(socket.handle(), reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0;
}

}  // namespace

std::vector<LocalAddress> localAddresses() {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return {};
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> owned(first, freeifaddrs);
  std::vector<LocalAddress> all;
  for (const ifaddrs* each = first; each != nullptr; each = each->ifa_next) {
    if (each->ifa_addr == nullptr || each->ifa_addr->sa_family != AF_INET || (each->ifa_flags & IFF_UP) == 0) continue;
    sockaddr_in address{};
    std::memcpy(&address, each->ifa_addr, sizeof address);
    all.push_back({each->ifa_name, address.sin_addr.s_addr, (each->ifa_flags & IFF_LOOPBACK) != 0});
  }
  std::ranges::stable_sort(all, {}, [](const LocalAddress& each) { return !each.isLoopback; });
  return all;
}

std::string textOf(std::uint32_t address) {
  char text[INET_ADDRSTRLEN] = {};
  const in_addr in{address};
  inet_ntop(AF_INET, &in, text, sizeof text);
  return text;
}

UdpSocket::~UdpSocket() {
  if (handle_ >= 0) close(handle_);
}

UdpSocket& UdpSocket::operator=(UdpSocket&& other) noexcept {
  std::swap(handle_, other.handle_);
  return *this;
}

UdpSocket openUnicast(std::uint16_t port, const shared::Senders& senders) {
  UdpSocket socket = open();
  // before it has a port, so that no packet arrives in between
  if (!socket || !shared::limitSenders(socket.handle(), senders) || !bindTo(socket, INADDR_ANY, port))
    return UdpSocket();
  return socket;
}

UdpSocket openMulticast(std::uint32_t group, std::uint16_t port, std::uint32_t interface,
                        const shared::Senders& senders) {
  UdpSocket socket = open();
  ip_mreq membership{};
  membership.imr_multiaddr.s_addr = group;
  membership.imr_interface.s_addr = interface;
  // otherwise it receives groups that other programs have joined on other interfaces
  if (!socket || !shared::limitSenders(socket.handle(), senders) || !set(socket, IPPROTO_IP, IP_MULTICAST_ALL, 0) ||
      !set(socket, SOL_SOCKET, SO_REUSEADDR, 1) || !bindTo(socket, group, port) ||
      !set(socket, IPPROTO_IP, IP_ADD_MEMBERSHIP, membership)) {
    return UdpSocket();
  }
  return socket;
}

UdpSocket openSender() {
  UdpSocket socket = open();
  if (!socket || !shared::refuseSenders(socket.handle())) return UdpSocket();
  return socket;
}

UdpSocket openGroupSender(std::uint32_t interface, int timeToLive) {
  UdpSocket socket = openSender();
  const in_addr by{interface};
  if (!socket || !set(socket, IPPROTO_IP, IP_MULTICAST_IF, by) ||
      !set(socket, IPPROTO_IP, IP_MULTICAST_TTL, timeToLive) || !set(socket, IPPROTO_IP, IP_MULTICAST_LOOP, 1) ||
      !bindTo(socket, interface, 0)) {
    return UdpSocket();
  }
  return socket;
}

}  // namespace pongsim::ros2
