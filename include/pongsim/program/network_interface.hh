#pragma once

#include <string>
#include <vector>

#include "pongsim/export.hh"

namespace pongsim {

/// An IPv4 address of this machine and its network interface.
struct NetworkInterface {
  std::string name;
  std::string address;
};

/// @return All interfaces that are up, one entry per address.
PONGSIM_API std::vector<NetworkInterface> networkInterfaces();

}  // namespace pongsim
