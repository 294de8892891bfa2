#pragma once

#include <optional>
#include <string>

#include "pongsim/network_interface.hh"

namespace pongsim::transport {

/// @param wanted An interface's name or address; unset or empty: what the environment variable PONGSIM_NETWORK says.
/// @return Where to talk to other machines; nothing where nobody says so, or says loopback: then to none.
/// @throws std::invalid_argument where there is none of that name or address; the message lists those that are there.
std::optional<NetworkInterface> chosenInterface(const std::optional<std::string>& wanted);

}  // namespace pongsim::transport
