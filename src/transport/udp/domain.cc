#include "transport/udp/domain.hh"

#include <netinet/in.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "base/parse_number.hh"
#include "pongsim/program/gazebo_variable.hh"
#include "transport/udp/udp_sockets.hh"

namespace pongsim::transport {

namespace {

constexpr int kLastDomain = 232;

// Number of discovery ports per domain: more than one machine runs, and few enough to stay below the ports of the next
// domain (port gain DG = 250).
constexpr std::uint32_t kParticipants = 115;

}  // namespace

int chosenDomain(std::optional<int> wanted) {
  if (wanted) {
    if (*wanted >= 0 && *wanted <= kLastDomain) return *wanted;
    throw std::invalid_argument("DDS domain " + std::to_string(*wanted) + " is not between 0 and 232");
  }
  const char* text = std::getenv("PONGSIM_DOMAIN");
  if (text == nullptr || *text == '\0') return 0;
  const std::optional<long long> number = base::parseInteger(text);
  if (number && *number >= 0 && *number <= kLastDomain) return static_cast<int>(*number);
  throw std::invalid_argument("PONGSIM_DOMAIN is '" + std::string(text) + "', not an integer between 0 and 232");
}

std::string chosenPartition() { return gazebo::kPartition.value(); }

std::uint32_t multicastPort(int domain) { return 7400 + 250 * static_cast<std::uint32_t>(domain); }

DiscoveryPorts discoveryPorts(int domain) {
  const std::uint32_t first = multicastPort(domain) + 10;
  return {first, std::min(kParticipants, (65535 - 1 - first) / 2)};
}

std::optional<std::vector<OpenPort>> openDiscoveryPorts(int domain) {
  const DiscoveryPorts ports = discoveryPorts(domain);
  const auto sockets =
      boundUdpSockets({static_cast<std::uint16_t>(ports.first), static_cast<std::uint16_t>(ports.last())});
  if (!sockets) return std::nullopt;
  std::vector<OpenPort> open;
  for (const BoundUdp& each : *sockets) {
    const bool isLoopback = each.address == INADDR_LOOPBACK;
    if (ports.contains(each.port) && (isLoopback || each.address == INADDR_ANY)) {
      open.push_back({each.port, isLoopback});
    }
  }
  return open;
}

}  // namespace pongsim::transport
