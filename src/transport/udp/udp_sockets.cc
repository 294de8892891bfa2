#include "transport/udp/udp_sockets.hh"

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
#include <utility>

#include "shared/sockets/udp_lookup.hh"

namespace pongsim::transport {

namespace {

/// An instruction of the INET_DIAG bytecode filter, which the kernel runs for each socket: compares the socket's port
/// with `with`, and jumps `ifSo` bytes forward if the comparison holds, else `ifNot` bytes. The socket is reported if
/// the jump ends exactly behind the last instruction.
struct Comparison {
  inet_diag_bc_op compare;
  inet_diag_bc_op port;

  Comparison(int code, std::size_t ifSo, std::size_t ifNot, std::uint16_t with)
      : compare{static_cast<unsigned char>(code), static_cast<unsigned char>(ifSo), static_cast<unsigned short>(ifNot)},
        port{0, 0, with} {}
};

/// A request to the kernel (sock_diag(7)) for the UDP sockets over IPv4 in a range of ports.
struct DiagRequest {
  nlmsghdr header{};
  inet_diag_req_v2 wanted{};
  nlattr filter{};
  std::array<Comparison, 2> steps;

  explicit DiagRequest(const PortRange& ports)
      : steps{Comparison(INET_DIAG_BC_S_GE, sizeof(Comparison), sizeof steps + sizeof(inet_diag_bc_op), ports.first),
              Comparison(INET_DIAG_BC_S_LE, sizeof(Comparison), sizeof(Comparison) + sizeof(inet_diag_bc_op),
                         ports.last)} {
    filter.nla_len = sizeof filter + sizeof steps;
    filter.nla_type = INET_DIAG_REQ_BYTECODE;
    header.nlmsg_len = sizeof *this;
    header.nlmsg_type = SOCK_DIAG_BY_FAMILY;
    header.nlmsg_flags = NLM_F_REQUEST | NLM_F_DUMP;
    wanted.sdiag_family = AF_INET;
    wanted.sdiag_protocol = IPPROTO_UDP;
    wanted.idiag_states = ~0U;
  }
};

enum class Rest { kMore, kNone, kRefused };

/// Reads one datagram of the kernel's answer.
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

struct Answer {
  std::vector<BoundUdp> sockets;
  /// Whether one datagram held all sockets. Between two, sockets may be opened and closed, and the kernel resumes its
  /// list by counting, so that some may be missing or listed twice.
  bool isInOnePiece = true;
};

std::optional<Answer> askKernel(int netlink, const PortRange& ports) {
  const DiagRequest request(ports);
  if (send(netlink, &request, sizeof request, 0) != sizeof request) return std::nullopt;
  Answer answer;
  alignas(nlmsghdr) std::array<std::byte, 32 << 10> piece;
  while (true) {
    const ssize_t size = recv(netlink, piece.data(), piece.size(), 0);
    if (size <= 0) return std::nullopt;
    const std::size_t before = answer.sockets.size();
    const Rest rest = readPiece(piece.data(), static_cast<std::size_t>(size), answer.sockets);
    if (rest == Rest::kRefused) return std::nullopt;
    if (before > 0 && answer.sockets.size() > before) answer.isInOnePiece = false;
    if (rest == Rest::kNone) return answer;
  }
}

/// @return Whether the kernel finds a socket that receives packets for the address.
bool findsSocket(int netlink, const BoundUdp& address) {
  alignas(nlmsghdr) shared::DiagAnswer answer;
  const auto bytes = shared::askForUdpSocket(netlink, htonl(address.address),
                                             htons(static_cast<std::uint16_t>(address.port)), 0, answer);
  std::vector<BoundUdp> sockets;
  if (bytes.empty() || readPiece(bytes.data(), bytes.size(), sockets) == Rest::kRefused) return false;
  return sockets.size() == 1 && sockets.front().port == address.port;
}

}  // namespace

std::optional<bool> isUdpOpen(const BoundUdp& address) {
  if (const int netlink = socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_SOCK_DIAG); netlink >= 0) {
    const bool isFound = findsSocket(netlink, address);
    close(netlink);
    if (isFound) return true;
  }
  // not found, or the kernel does not support the look-up: list the sockets
  const auto port = static_cast<std::uint16_t>(address.port);
  const auto sockets = boundUdpSockets({port, port});
  if (!sockets) return std::nullopt;
  return std::ranges::any_of(
      *sockets, [&](const BoundUdp& each) { return each.address == address.address || each.address == 0; });
}

std::optional<std::vector<BoundUdp>> boundUdpSockets(const PortRange& ports) {
  if (auto sockets = udpSocketsBySockDiag(ports)) return sockets;
  return udpSocketsByProc(ports);
}

std::optional<std::vector<BoundUdp>> udpSocketsBySockDiag(const PortRange& ports) {
  const int netlink = socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_SOCK_DIAG);
  if (netlink < 0) return std::nullopt;
  auto answer = askKernel(netlink, ports);
  // The kernel fills datagrams of one page until it has passedSequence the reader's buffer size, so a second request
  // may fit into one datagram.
  if (answer && !answer->isInOnePiece) answer = askKernel(netlink, ports);
  close(netlink);
  if (!answer) return std::nullopt;
  return std::move(answer->sockets);
}

std::optional<std::vector<BoundUdp>> udpSocketsByProc(const PortRange& ports) {
  // /proc/net is a link to /proc/self/net, and is missing if /proc is mounted with subset=pid (systemd: ProcSubset)
  std::ifstream table("/proc/self/net/udp");
  if (!table) return std::nullopt;
  std::vector<BoundUdp> sockets;
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    // the kernel prints the address as a 32-bit number whose bytes are in network order
    unsigned address = 0;
    unsigned port = 0;
    if (std::sscanf(line.c_str(), " %*u: %8X:%4X", &address, &port) != 2) continue;
    if (port >= ports.first && port <= ports.last) sockets.push_back({ntohl(address), port});
  }
  return sockets;
}

}  // namespace pongsim::transport
