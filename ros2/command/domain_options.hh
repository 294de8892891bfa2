#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ros2/wire/participant.hh"

namespace CLI {
class App;
}

namespace pongsim::ros2 {

/// Where the nodes are that an action talks with, as the user says it.
struct DomainOptions {
  std::optional<std::string> domain;
  std::optional<std::string> distro;
  std::optional<std::string> network;

  /// @return With what the environment says where these do not.
  /// @throws UsageError for a domain, distribution or interface that is none.
  ParticipantOptions participant() const;
};

/// Takes the value of `--secure`: this process is to be an identity of that keystore.
/// @throws UsageError for an empty one, which would mean that nothing is secured.
void takeKeystore(const std::string& place);

/// Gives an action the options `--domain`, `--distro` and `--network`.
void addDomainOptions(CLI::App& action, const std::shared_ptr<DomainOptions>& given);

}  // namespace pongsim::ros2
