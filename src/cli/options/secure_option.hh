#pragma once

namespace CLI {
class App;
}

namespace pongsim::cli {

/// Adds the option `--secure` to a command that communicates with other processes. The option sets the environment
/// variable PONGSIM_SECURITY for all transports that the command creates.
void addSecureOption(CLI::App& command);

}  // namespace pongsim::cli
