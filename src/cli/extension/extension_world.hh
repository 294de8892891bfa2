#pragma once

#include <optional>
#include <string>

#include "cli/extension/extension.hh"

namespace pongsim::cli {

/// Runs an extension's program that prints a world in SDF, and waits for it. The user sees its stderr.
/// @return What it printed; nothing if it failed, which it reports itself, or could not be run, which is reported here.
std::optional<std::string> printedWorld(const Extension::WorldSource& source);

}  // namespace pongsim::cli
