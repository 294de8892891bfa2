#pragma once

#include <string>
#include <vector>

#include "pongsim/export.hh"

namespace pongsim {

/// An address of this machine, IPv4, and the network interface that it belongs to.
struct NetworkInterface {
  std::string name;
  std::string address;
};

/// @return Those that are up, one for each address.
PONGSIM_API std::vector<NetworkInterface> networkInterfaces();

}  // namespace pongsim
