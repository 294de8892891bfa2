#pragma once

#include <optional>
#include <string>

#include "cli/extension/extension.hh"

namespace pongsim::cli {

/// Runs a program of an extension that prints a world in SDF, and waits for it. What it says on stderr the user sees.
/// @return What it printed; nothing where it failed, which it has said itself, or could not be run, which is said.
std::optional<std::string> printedWorld(const Extension::WorldSource& source);

}  // namespace pongsim::cli
