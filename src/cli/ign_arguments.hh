#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pongsim::cli {

/// @param program How the program was called: a path or a name.
/// @return Whether it was called as Fortress's `ign` or its successors' `gz`, by a link of that name.
bool isCalledAsIgn(std::string_view program);

/// Translates a command line for `ign` or `gz` into one for `pongsim`: `ign gazebo -s -r world.sdf` means
/// `pongsim run world.sdf`, and without `-r` begins paused. The other commands are called the same.
/// @throws UsageError where it asks for what needs a display, or for a world that several processes share.
std::vector<std::string> fromIgnArguments(std::vector<std::string> arguments);

}  // namespace pongsim::cli
