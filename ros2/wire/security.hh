#pragma once

#include <optional>
#include <string>

#include "pongsim/program/keystore.hh"

namespace pongsim::ros2 {

/// How nodes are secured.
struct Security {
  /// Unset: they are not.
  std::optional<SecureIdentity> identity;
  /// What the user should know about that, or empty.
  std::string warning;
};

/// @return What ROS_SECURITY_ENABLE, ROS_SECURITY_KEYSTORE, ROS_SECURITY_ENCLAVE_OVERRIDE and ROS_SECURITY_STRATEGY
/// say, as rcl has it; where the first of them says nothing, what PONGSIM_SECURITY does.
/// @param domain That of the nodes.
/// @throws KeystoreError where they are to be secured and can't be.
Security securityOfEnvironment(int domain);

}  // namespace pongsim::ros2
