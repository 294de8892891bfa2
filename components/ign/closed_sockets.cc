#include "ign/closed_sockets.hh"

#include <arpa/inet.h>
#include <linux/filter.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "ign/library.hh"
#include "pongsim/program/network_interface.hh"

namespace pongsim::ign {

namespace {

// Offset of the sender's address in an IPv4 header.
constexpr std::uint32_t kSourceAddress = 12;

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

sock_filter statement(std::uint32_t code, std::uint32_t value) {
  return {static_cast<std::uint16_t>(code), 0, 0, value};
}

/// @return A program of the kernel's packet filter (socket(7), SO_ATTACH_FILTER) that accepts packets from 127.0.0.0/8
/// and from this machine's other addresses, which clients with default settings use. The kernel itself drops packets
/// from elsewhere with such a sender.
std::vector<sock_filter> ownSendersOnly() {
  std::vector<std::uint32_t> own;
  for (const NetworkInterface& each : networkInterfaces()) own.push_back(ntohl(inet_addr(each.address.c_str())));
  // the longest possible jump
  own.resize(std::min<std::size_t>(own.size(), 200));
  std::vector<sock_filter> filter;
  filter.push_back(statement(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(SKF_NET_OFF) + kSourceAddress));
  // each jump skips the remaining comparisons and the refusal
  for (std::size_t i = 0; i < own.size(); ++i) {
    filter.push_back({BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint8_t>(own.size() - i - 1 + 3), 0, own[i]});
  }
  filter.push_back(statement(BPF_ALU | BPF_AND | BPF_K, 0xff000000));
  filter.push_back({BPF_JMP | BPF_JEQ | BPF_K, 1, 0, 0x7f000000});
  filter.push_back(statement(BPF_RET | BPF_K, 0));
  filter.push_back(statement(BPF_RET | BPF_K, 0xffffffff));
  return filter;
}

bool limit(int handle, std::vector<sock_filter>& filter) {
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return setsockopt(handle, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) == 0;
}

}  // namespace

int closeDiscoveryToOthers() {
  std::vector<sock_filter> filter = ownSendersOnly();
  int count = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const std::string name = entry.path().filename();
    int handle = -1;
    if (std::from_chars(name.data(), name.data() + name.size(), handle).ec != std::errc()) continue;
    if (isDiscovery(handle) && limit(handle, filter)) ++count;
  }
  return count;
}

}  // namespace pongsim::ign
