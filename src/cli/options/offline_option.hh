#pragma once

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace pongsim::cli {

/// Adds the option `--offline` to a command that reads worlds. The option sets the environment variable
/// PONGSIM_OFFLINE.
CLI::Option* addOfflineOption(CLI::App& command);

}  // namespace pongsim::cli
