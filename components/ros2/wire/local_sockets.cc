#include "ros2/wire/local_sockets.hh"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <linux/filter.h>
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
// Offsets of the addresses in an IPv4 header.
constexpr std::uint32_t kSourceAddress = 12;
constexpr std::uint32_t kDestinationAddress = 16;
constexpr std::uint32_t kWholePacket = 0xffffffff;
// Longest jump in a filter.
constexpr std::size_t kMostAddresses = 200;

template <class Value>
bool set(const UdpSocket& socket, int level, int name, const Value& value) {
  return setsockopt(socket.handle(), level, name, &value, sizeof value) == 0;
}

bool attach(const UdpSocket& socket, std::vector<sock_filter>& filter) {
  return set(socket, SOL_SOCKET, SO_ATTACH_FILTER,
             sock_fprog{static_cast<unsigned short>(filter.size()), filter.data()});
}

sock_filter statement(std::uint32_t code, std::uint32_t value) {
  return {static_cast<std::uint16_t>(code), 0, 0, value};
}

/// Installs the filter for `senders` as a program of the kernel's classic packet filter (socket(7), SO_ATTACH_FILTER).
bool limit(const UdpSocket& socket, const Senders& senders) {
  if (senders.isAnybody) return true;
  if (senders.addresses.size() > kMostAddresses) return false;
  const std::size_t count = senders.addresses.size();
  const auto load = [](std::uint32_t offset) {
    return statement(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(SKF_NET_OFF) + offset);
  };
  std::vector<sock_filter> filter;
  if (senders.openAddress) {
    filter.push_back(load(kDestinationAddress));
    filter.push_back({BPF_JMP | BPF_JEQ | BPF_K, 0, 1, ntohl(*senders.openAddress)});
    filter.push_back(statement(BPF_RET | BPF_K, kWholePacket));
  }
  filter.push_back(load(kSourceAddress));
  // each jump skips the remaining comparisons and the refusal
  for (std::size_t i = 0; i < count; ++i) {
    filter.push_back(
        {BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint8_t>(count - i - 1 + 3), 0, ntohl(senders.addresses[i])});
  }
  filter.push_back(statement(BPF_ALU | BPF_AND | BPF_K, 0xff000000));
  filter.push_back({BPF_JMP | BPF_JEQ | BPF_K, 1, 0, 0x7f000000});
  filter.push_back(statement(BPF_RET | BPF_K, 0));
  filter.push_back(statement(BPF_RET | BPF_K, kWholePacket));
  return attach(socket, filter);
}

bool hearNothing(const UdpSocket& socket) {
  std::vector<sock_filter> filter{statement(BPF_RET | BPF_K, 0)};
  return attach(socket, filter);
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

UdpSocket openUnicast(std::uint16_t port, const Senders& senders) {
  UdpSocket socket = open();
  // before it has a port, so that no packet arrives in between
  if (!socket || !limit(socket, senders) || !bindTo(socket, INADDR_ANY, port)) return UdpSocket();
  return socket;
}

UdpSocket openMulticast(std::uint32_t group, std::uint16_t port, std::uint32_t interface, const Senders& senders) {
  UdpSocket socket = open();
  ip_mreq membership{};
  membership.imr_multiaddr.s_addr = group;
  membership.imr_interface.s_addr = interface;
  // otherwise it receives groups that other programs have joined on other interfaces
  if (!socket || !limit(socket, senders) || !set(socket, IPPROTO_IP, IP_MULTICAST_ALL, 0) ||
      !set(socket, SOL_SOCKET, SO_REUSEADDR, 1) || !bindTo(socket, group, port) ||
      !set(socket, IPPROTO_IP, IP_ADD_MEMBERSHIP, membership)) {
    return UdpSocket();
  }
  return socket;
}

UdpSocket openSender() {
  UdpSocket socket = open();
  if (!socket || !hearNothing(socket)) return UdpSocket();
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
