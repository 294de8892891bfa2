#pragma once

#include <optional>
#include <string>

#include "pongsim/program/keystore.hh"

namespace pongsim::ros2 {

/// How nodes are secured.
struct Security {
  /// Unset: not secured.
  std::optional<SecureIdentity> identity;
  /// A warning for the user, or empty.
  std::string warning;
};

/// @return The security set by ROS_SECURITY_ENABLE, ROS_SECURITY_KEYSTORE, ROS_SECURITY_ENCLAVE_OVERRIDE and
/// ROS_SECURITY_STRATEGY, with rcl's rules; if the first is not set, by PONGSIM_SECURITY.
/// @param domain Domain of the nodes.
/// @throws KeystoreError if nodes should be secured but can't be.
Security securityOfEnvironment(int domain);

}  // namespace pongsim::ros2
