#pragma once

namespace CLI {
class App;
}

namespace pongsim::cli {

/// Gives a command that talks to other processes the option `--secure`. It stands for the environment variable
/// PONGSIM_SECURITY, which it sets for all transports that the command makes.
void addSecureOption(CLI::App& command);

}  // namespace pongsim::cli
