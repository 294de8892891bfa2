#pragma once

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace pongsim::cli {

/// Gives a command that reads worlds the option `--offline`. It stands for the environment variable PONGSIM_OFFLINE,
/// which it sets.
CLI::Option* addOfflineOption(CLI::App& command);

}  // namespace pongsim::cli
