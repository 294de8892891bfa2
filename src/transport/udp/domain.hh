#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pongsim::transport {

/// @return `wanted`, else the environment variable PONGSIM_DOMAIN, else 0.
/// @throws std::invalid_argument for anything but an integer from 0 to 232.
int chosenDomain(std::optional<int> wanted);

/// @return The environment variable IGN_PARTITION, else GZ_PARTITION; empty: no partition.
std::string chosenPartition();

/// The unicast ports of a domain for participant discovery (SPDP), by the RTPS specification (9.6.1.1): PB + DG *
/// domain + d1 + PG * participant = 7400 + 250 * domain + 10 + 2 * participant.
struct DiscoveryPorts {
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  std::uint32_t last() const { return first + 2 * (count - 1); }
  bool contains(std::uint32_t port) const { return port >= first && port <= last() && (port - first) % 2 == 0; }
};
DiscoveryPorts discoveryPorts(int domain);

/// @return The domain's multicast discovery port: PB + DG * domain = 7400 + 250 * domain. Not used on loopback.
std::uint32_t multicastPort(int domain);

struct OpenPort {
  std::uint32_t port = 0;
  /// Whether the socket is bound to 127.0.0.1, as those of pongsim are, and not to all addresses.
  bool isOnLoopbackAlone = false;
};

/// @return The discovery ports of the domain at which a socket of this machine receives packets for 127.0.0.1; nothing
/// if the system does not report them.
std::optional<std::vector<OpenPort>> openDiscoveryPorts(int domain);

}  // namespace pongsim::transport
