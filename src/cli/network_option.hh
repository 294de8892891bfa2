#pragma once

namespace CLI {
class App;
}

namespace pongsim::cli {

/// Gives a command that talks to other processes the option `--network`. It stands for the environment variable
/// PONGSIM_NETWORK, which it sets for all transports that the command makes.
void addNetworkOption(CLI::App& command);

}  // namespace pongsim::cli
