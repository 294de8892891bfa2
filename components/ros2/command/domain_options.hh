#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ros2/wire/participant.hh"

namespace CLI {
class App;
}

namespace pongsim::ros2 {

/// The user's options for reaching the nodes that an action communicates with.
struct DomainOptions {
  std::optional<std::string> domain;
  std::optional<std::string> distro;
  std::optional<std::string> network;

  /// @return The options, completed from the environment.
  /// @throws cli::UsageError for an invalid domain, distribution or interface.
  ParticipantOptions participant() const;
};

/// Handles the value of `--secure`: this process uses an identity of that keystore.
/// @throws cli::UsageError if it is empty, which would mean no security.
void takeKeystore(const std::string& place);

/// Adds the options `--domain`, `--distro` and `--network` to an action.
void addDomainOptions(CLI::App& action, const std::shared_ptr<DomainOptions>& given);

}  // namespace pongsim::ros2
