#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

namespace pongsim::transport {

/// A UDP socket over IPv4 of any process that is bound to a port.
struct BoundUdp {
  /// In the host's byte order; 0 is any.
  std::uint32_t address = 0;
  std::uint32_t port = 0;
  auto operator<=>(const BoundUdp&) const = default;
};

struct PortRange {
  std::uint16_t first = 0;
  std::uint16_t last = 0;
};

/// @return Those at these ports of this machine (of this network namespace), in no order; nothing where the system does
/// not tell.
std::optional<std::vector<BoundUdp>> boundUdpSockets(const PortRange& ports);

/// As `boundUdpSockets` by the kernel's sock_diag(7): quick, and complete while others come and go, for as many as it
/// tells at once, some fifty at least. Not every container or kernel has it.
std::optional<std::vector<BoundUdp>> udpSocketsBySockDiag(const PortRange& ports);

/// As `boundUdpSockets` by /proc/net/udp. While others come and go some may be missing or be there twice: the kernel
/// tells of all the machine's in pieces of a page, and counts to where the next one begins.
std::optional<std::vector<BoundUdp>> udpSocketsByProc(const PortRange& ports);

}  // namespace pongsim::transport
