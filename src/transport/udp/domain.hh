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

/// The ports by which processes of a domain discover each other, numbered as in the RTPS specification (9.6.1.1): one
/// for each participant, two apart.
struct DiscoveryPorts {
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  std::uint32_t last() const { return first + 2 * (count - 1); }
  bool contains(std::uint32_t port) const { return port >= first && port <= last() && (port - first) % 2 == 0; }
};
DiscoveryPorts discoveryPorts(int domain);

/// @return The port of their multicast group, if they use it.
std::uint32_t multicastPort(int domain);

struct OpenPort {
  std::uint32_t port = 0;
  /// Whether it is only open on 127.0.0.1, like ours.
  bool isOnLoopbackAlone = false;
};

/// @return Discovery ports with a process on this machine that receives from 127.0.0.1; nothing if the system does not
/// report them.
std::optional<std::vector<OpenPort>> openDiscoveryPorts(int domain);

}  // namespace pongsim::transport
