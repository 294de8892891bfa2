#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pongsim::cli {

/// Moves options of `pongsim run` with an optional number to the end of the command line if no number follows them.
/// Otherwise CLI11 would take the next word, such as the world file, for the value.
/// @param arguments The command and its words.
std::vector<std::string> withOptionalValuesLast(std::vector<std::string> arguments, const CLI::App& program);

}  // namespace pongsim::cli
