#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::cli {

/// The program of Gazebo in whose place pongsim is called.
enum class GazeboProgram {
  /// That of Fortress.
  kIgn,
  /// That of Garden and later releases.
  kGz
};

/// The meaning of a command line for `ign` or `gz`.
struct IgnLine {
  /// A command line for `pongsim`.
  std::vector<std::string> arguments;
  /// Text to print instead.
  std::optional<std::string> text = std::nullopt;
};

/// @param program How the program was called: a path or a name.
/// @return Which one it was called as, through a link with that name; nothing under any other name.
std::optional<GazeboProgram> calledAs(std::string_view program);

/// Translates a command line for `ign` or `gz` into one for `pongsim`: `ign gazebo -s -r world.sdf` and `gz sim -s -r
/// world.sdf` become `pongsim run world.sdf`, and without `-r` the run starts paused. The other commands have the same
/// names. Options that the program itself handles (`--versions`, `--force-version`, `--commands`, `help`) work for all
/// of them.
/// @throws UsageError if it asks for a version that is none of that program's: Fortress's, or those of Garden to Jetty.
IgnLine fromIgnArguments(GazeboProgram program, const std::vector<std::string>& arguments);

}  // namespace pongsim::cli
