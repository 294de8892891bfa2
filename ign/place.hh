#pragma once

#include <cstddef>
#include <string>

namespace pongsim::ign {

/// Where a process speaks ign-transport.
struct Place {
  /// IPv4 address of this machine.
  std::string address;
  /// Whether other machines can reach it.
  bool isOpen = false;
  std::string partition;
};

/// @return What IGN_IP says, else the address of the interface that PONGSIM_NETWORK names, else 127.0.0.1; the
/// partition is IGN_PARTITION's, else HOST:USER.
/// @throws std::invalid_argument where that is no address or no interface of this machine, or no partition.
Place placeOfEnvironment();

/// Has ign-transport speak there, by its environment variables. To be called before anything else of it.
/// @param queueLength How many messages wait for each reader, unless IGN_TRANSPORT_SNDHWM says so.
void settle(const Place& place, int queueLength);

}  // namespace pongsim::ign
