#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pongsim::cli {

/// Puts options of `pongsim run` whose value, a number, may be left out behind all other words where no number follows
/// them: what follows is another word then, such as the world's file, and CLI11 would take it for the value.
/// @param arguments The command and its words.
std::vector<std::string> withOptionalValuesLast(std::vector<std::string> arguments, const CLI::App& program);

}  // namespace pongsim::cli
