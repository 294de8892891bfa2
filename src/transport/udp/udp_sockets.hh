#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

namespace pongsim::transport {

/// A UDP socket over IPv4 that a process has bound to a port.
struct BoundUdp {
  /// In host byte order; 0: any address.
  std::uint32_t address = 0;
  std::uint32_t port = 0;
  auto operator<=>(const BoundUdp&) const = default;
};

struct PortRange {
  std::uint16_t first = 0;
  std::uint16_t last = 0;
};

/// @return The sockets at these ports in this network namespace, in no order; nothing if the system does not report
/// them.
std::optional<std::vector<BoundUdp>> boundUdpSockets(const PortRange& ports);

/// @return Whether a socket in this network namespace receives what is sent to the address; nothing if the system does
/// not report it. Faster than a list of sockets where there is one.
std::optional<bool> isUdpOpen(const BoundUdp& address);

/// Like `boundUdpSockets`, with the kernel's sock_diag(7): fast, and consistent while sockets are opened and closed,
/// for as many as fit into one answer, some two hundred. Not available in every container and kernel.
std::optional<std::vector<BoundUdp>> udpSocketsBySockDiag(const PortRange& ports);

/// Like `boundUdpSockets`, with /proc/self/net/udp. While sockets are opened and closed, some may be missing or listed
/// twice: the kernel lists all of the machine's page by page, and remembers its position by counting.
std::optional<std::vector<BoundUdp>> udpSocketsByProc(const PortRange& ports);

}  // namespace pongsim::transport
