#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::cli {

/// What a command line for `ign` or `gz` means here.
struct IgnLine {
  /// A command line for `pongsim`.
  std::vector<std::string> arguments;
  /// In place of that: what to print.
  std::optional<std::string> text = std::nullopt;
};

/// @param program How the program was called: a path or a name.
/// @return Whether it was called as Fortress's `ign` or its successors' `gz`, by a link of that name.
bool isCalledAsIgn(std::string_view program);

/// Translates a command line for `ign` or `gz` into one for `pongsim`: `ign gazebo -s -r world.sdf` means
/// `pongsim run world.sdf`, and without `-r` begins paused. The other commands are called the same. What the program
/// `ign` itself answers there (`--versions`, `--force-version`, `--commands`, `help`) is answered for all of them.
/// @throws UsageError where it asks for a version of Gazebo that is not Fortress.
IgnLine fromIgnArguments(const std::vector<std::string>& arguments);

}  // namespace pongsim::cli
