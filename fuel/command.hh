#pragma once

#include <string>
#include <vector>

#include "programs/command_line.hh"

namespace pongsim::fuel {

/// Adds the actions of `pongsim fuel`. They stand in share/fuel.json, too, for help and completion.
void addActions(CLI::App& program, programs::Work& work);

/// @return The words of a command line.
/// @throws UsageError where they want what `ign fuel` does and this does not.
std::vector<std::string> checkedWords(std::vector<std::string> words);

}  // namespace pongsim::fuel
