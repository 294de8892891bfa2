#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::cli {

/// The meaning of a command line for `ign` or `gz`.
struct IgnLine {
  /// A command line for `pongsim`.
  std::vector<std::string> arguments;
  /// Text to print instead.
  std::optional<std::string> text = std::nullopt;
};

/// @param program How the program was called: a path or a name.
/// @return Whether it was called as Fortress's `ign` or its successors' `gz`, through a link with that name.
bool isCalledAsIgn(std::string_view program);

/// Translates a command line for `ign` or `gz` into one for `pongsim`: `ign gazebo -s -r world.sdf` becomes `pongsim
/// run world.sdf`, and without `-r` the run starts paused. The other commands have the same names. Options that the
/// program `ign` itself handles (`--versions`, `--force-version`, `--commands`, `help`) work for all of them.
/// @throws UsageError if it asks for a version of Gazebo other than Fortress.
IgnLine fromIgnArguments(const std::vector<std::string>& arguments);

}  // namespace pongsim::cli
