#pragma once

#include <cstddef>
#include <string>

namespace pongsim::ign {

/// The address and partition of a process on ign-transport.
struct Place {
  /// IPv4 address of this machine.
  std::string address;
  /// Whether other machines can reach it.
  bool isOpen = false;
  std::string partition;
};

/// @return The address in IGN_IP, else that of the interface named in PONGSIM_NETWORK, else 127.0.0.1; the partition is
/// IGN_PARTITION, else HOST:USER.
/// @throws std::invalid_argument if that is not an address or interface of this machine, or not a valid partition.
Place placeOfEnvironment();

/// Sets the environment variables that make ign-transport use that place. Call before anything else of the library.
/// @param queueLength Maximum number of messages queued for each subscriber, unless IGN_TRANSPORT_SNDHWM is set.
void settle(const Place& place, int queueLength);

}  // namespace pongsim::ign
