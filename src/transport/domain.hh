#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pongsim::transport {

/// @return `wanted`, else what the environment variable PONGSIM_DOMAIN says, else 0.
/// @throws std::invalid_argument for anything but an integer from 0 to 232.
int chosenDomain(std::optional<int> wanted);

/// @return What the environment variable IGN_PARTITION says, or else GZ_PARTITION; empty: no partition.
std::string chosenPartition();

/// The ports by which the processes of a domain find each other, as the RTPS specification (9.6.1.1) numbers them:
/// one for each participant, two apart.
struct DiscoveryPorts {
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  std::uint32_t last() const { return first + 2 * (count - 1); }
  bool contains(std::uint32_t port) const { return port >= first && port <= last() && (port - first) % 2 == 0; }
};
DiscoveryPorts discoveryPorts(int domain);

/// @return The port at which they listen to their multicast group, where they do.
std::uint32_t multicastPort(int domain);

struct OpenPort {
  std::uint32_t port = 0;
  /// Whether it is open on 127.0.0.1 alone, as ours are.
  bool isOnLoopbackAlone = false;
};

/// @return Those of the ports at which a process of this machine hears what is sent to 127.0.0.1 now; nothing where the
/// system does not tell.
std::optional<std::vector<OpenPort>> openDiscoveryPorts(int domain);

}  // namespace pongsim::transport
