#pragma once

#include <string>

namespace CLI {
class App;
}

namespace pongsim::cli {

/// Completes the descriptor of a component (docs/extensions.md) with the actions of its program and their options, as the
/// program itself parses them.
/// @param file The part that is written by hand.
/// @return JSON.
/// @throws nlohmann::json::exception, a std::exception, if the file is not JSON.
std::string descriptorWithActions(const std::string& file, const CLI::App& program);

}  // namespace pongsim::cli
