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

/// @return The UDP sockets bound to these ports in this network namespace, in no particular order; nothing if the
/// system does not report them.
std::optional<std::vector<BoundUdp>> boundUdpSockets(const PortRange& ports);

/// @return Whether a socket in this network namespace receives packets for the address; nothing if the system does not
/// report it. Faster than `boundUdpSockets` if the kernel supports the look-up.
std::optional<bool> isUdpOpen(const BoundUdp& address);

/// Like `boundUdpSockets`, by the kernel's sock_diag(7): fast, and consistent while sockets are opened and closed if
/// all fit into one datagram, which holds about two hundred. Not available in every container and kernel.
std::optional<std::vector<BoundUdp>> udpSocketsBySockDiag(const PortRange& ports);

/// Like `boundUdpSockets`, by /proc/self/net/udp. While sockets are opened and closed, some may be missing or listed
/// twice: the kernel lists all of the machine page by page, and resumes by counting.
std::optional<std::vector<BoundUdp>> udpSocketsByProc(const PortRange& ports);

}  // namespace pongsim::transport
