#pragma once

#include <string>
#include <vector>

namespace pongsim::ign {

/// A network interface that is up.
struct Interface {
  std::string name;
  /// IPv4.
  std::string address;
};

/// @return Those of this machine, one for each address.
std::vector<Interface> interfaces();

}  // namespace pongsim::ign
