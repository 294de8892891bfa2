#include "transport/domain.hh"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

#include "base/parse_number.hh"

namespace pongsim::transport {

namespace {

constexpr int kLastDomain = 232;

// Enough participants for any one machine, and not so many that they run into the next domain's ports.
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

std::string chosenPartition() {
  for (const char* name : {"IGN_PARTITION", "GZ_PARTITION"}) {
    const char* text = std::getenv(name);
    if (text != nullptr && *text != '\0') return text;
  }
  return {};
}

std::uint32_t multicastPort(int domain) { return 7400 + 250 * static_cast<std::uint32_t>(domain); }

DiscoveryPorts discoveryPorts(int domain) {
  const std::uint32_t first = multicastPort(domain) + 10;
  return {first, std::min(kParticipants, (65535 - 1 - first) / 2)};
}

std::optional<std::vector<OpenPort>> openDiscoveryPorts(int domain) {
  std::ifstream table("/proc/net/udp");
  if (!table) return std::nullopt;
  const DiscoveryPorts ports = discoveryPorts(domain);
  std::vector<OpenPort> open;
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    unsigned address = 0;
    unsigned port = 0;
    if (std::sscanf(line.c_str(), " %*u: %8X:%4X", &address, &port) != 2) continue;
    const bool ours = port >= ports.first && port < ports.first + 2 * ports.count && (port - ports.first) % 2 == 0;
    // 127.0.0.1 as the kernel prints it on a little-endian machine, or any address
    const bool isLoopback = address == 0x0100007F;
    if (ours && (isLoopback || address == 0)) open.push_back({port, isLoopback});
  }
  return open;
}

}  // namespace pongsim::transport
