#pragma once

namespace CLI {
class App;
}

namespace pongsim::cli {

/// Adds the option `--renderer` to a command that draws. The option sets the environment variable PONGSIM_RENDERER for
/// all that the command draws.
void addRendererOption(CLI::App& command);

}  // namespace pongsim::cli
