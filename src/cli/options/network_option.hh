#pragma once

namespace CLI {
class App;
}

namespace pongsim::cli {

/// Adds the option `--network` to a command that communicates with other processes. The option sets the environment
/// variable PONGSIM_NETWORK for all transports that the command creates.
void addNetworkOption(CLI::App& command);

}  // namespace pongsim::cli
