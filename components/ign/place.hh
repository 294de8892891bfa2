#pragma once

#include <cstddef>
#include <string>

#include "ign/generation.hh"

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
/// IGN_PARTITION, else HOST:USER. For later clients the variables are GZ_IP and GZ_PARTITION.
/// @throws std::invalid_argument if that is not an address or interface of this machine, or not a valid partition.
Place placeOfEnvironment(Generation generation);

/// Sets the environment variables that make ign-transport use that place. For later clients it sets each variable of
/// Fortress, which the library reads, to what the later one says, or unsets it, for the whole process. Call before
/// anything else of the library.
/// @param queueLength Maximum number of messages queued for each subscriber, unless IGN_TRANSPORT_SNDHWM (or
/// GZ_TRANSPORT_SNDHWM) is set.
void settle(const Place& place, int queueLength, Generation generation);

}  // namespace pongsim::ign
