#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pongsim::transport {

/// An address of this machine, IPv4, and the network interface that it belongs to.
struct Interface {
  std::string name;
  std::string address;
};

/// @return Those that are up.
std::vector<Interface> interfaces();

/// @param wanted An interface's name or address; unset or empty: what the environment variable PONGSIM_NETWORK says.
/// @return Where to talk to other machines; nothing where nobody says so, or says loopback: then to none.
/// @throws std::invalid_argument where there is none of that name or address; the message lists those that are there.
std::optional<Interface> chosenInterface(const std::optional<std::string>& wanted);

}  // namespace pongsim::transport
