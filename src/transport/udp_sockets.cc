#include "transport/udp_sockets.hh"

#include <linux/inet_diag.h>
#include <linux/netlink.h>
#include <linux/sock_diag.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

namespace pongsim::transport {

namespace {

/// A question to the kernel for all UDP sockets over IPv4.
struct Question {
  nlmsghdr header{};
  inet_diag_req_v2 wanted{};

  Question() {
    header.nlmsg_len = sizeof *this;
    header.nlmsg_type = SOCK_DIAG_BY_FAMILY;
    header.nlmsg_flags = NLM_F_REQUEST | NLM_F_DUMP;
    wanted.sdiag_family = AF_INET;
    wanted.sdiag_protocol = IPPROTO_UDP;
    wanted.idiag_states = ~0U;
  }
};

enum class Rest { kMore, kNone, kRefused };

/// Reads one piece of the answer.
Rest readPiece(const std::byte* bytes, std::size_t size, std::vector<BoundUdp>& sockets) {
  while (size >= sizeof(nlmsghdr)) {
    nlmsghdr header{};
    std::memcpy(&header, bytes, sizeof header);
    if (header.nlmsg_len < sizeof header || header.nlmsg_len > size) return Rest::kRefused;
    if (header.nlmsg_type == NLMSG_DONE) return Rest::kNone;
    if (header.nlmsg_type != SOCK_DIAG_BY_FAMILY) return Rest::kRefused;
    inet_diag_msg socket{};
    if (header.nlmsg_len < NLMSG_HDRLEN + sizeof socket) return Rest::kRefused;
    std::memcpy(&socket, bytes + NLMSG_HDRLEN, sizeof socket);
    sockets.push_back({ntohl(socket.id.idiag_src[0]), ntohs(socket.id.idiag_sport)});
    const std::size_t step = std::min<std::size_t>(NLMSG_ALIGN(header.nlmsg_len), size);
    bytes += step;
    size -= step;
  }
  return Rest::kMore;
}

std::optional<std::vector<BoundUdp>> askKernel(int netlink) {
  const Question question;
  if (send(netlink, &question, sizeof question, 0) != sizeof question) return std::nullopt;
  std::vector<BoundUdp> sockets;
  alignas(nlmsghdr) std::array<std::byte, 32 << 10> piece;
  while (true) {
    const ssize_t size = recv(netlink, piece.data(), piece.size(), 0);
    if (size <= 0) return std::nullopt;
    const Rest rest = readPiece(piece.data(), static_cast<std::size_t>(size), sockets);
    if (rest == Rest::kNone) return sockets;
    if (rest == Rest::kRefused) return std::nullopt;
  }
}

}  // namespace

std::optional<std::vector<BoundUdp>> boundUdpSockets() {
  if (auto sockets = udpSocketsBySockDiag()) return sockets;
  return udpSocketsByProc();
}

std::optional<std::vector<BoundUdp>> udpSocketsBySockDiag() {
  const int netlink = socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_SOCK_DIAG);
  if (netlink < 0) return std::nullopt;
  auto sockets = askKernel(netlink);
  close(netlink);
  return sockets;
}

std::optional<std::vector<BoundUdp>> udpSocketsByProc() {
  std::ifstream table("/proc/net/udp");
  if (!table) return std::nullopt;
  std::vector<BoundUdp> sockets;
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    // the address as it lies in memory, in the network's byte order
    unsigned address = 0;
    unsigned port = 0;
    if (std::sscanf(line.c_str(), " %*u: %8X:%4X", &address, &port) == 2) sockets.push_back({ntohl(address), port});
  }
  return sockets;
}

}  // namespace pongsim::transport
