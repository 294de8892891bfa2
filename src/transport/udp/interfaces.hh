#pragma once

#include <optional>
#include <string>

#include "pongsim/program/network_interface.hh"

namespace pongsim::transport {

/// @param wanted An interface's name or IPv4 address; unset or empty: the environment variable PONGSIM_NETWORK.
/// @return The interface over which to communicate with other machines; nothing if none or loopback is chosen.
/// @throws std::invalid_argument if there is no such interface; the message lists the existing ones.
std::optional<NetworkInterface> chosenInterface(const std::optional<std::string>& wanted);

}  // namespace pongsim::transport
