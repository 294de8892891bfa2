#pragma once

#include <string>
#include <vector>

#include "shared/program/command_line.hh"

namespace pongsim::fuel {

/// Adds the actions of `pongsim fuel`.
void addActions(CLI::App& program, cli::Work& work);

/// @return The words of a command line.
/// @throws UsageError for features of `ign fuel` that are not supported.
std::vector<std::string> checkedWords(std::vector<std::string> words, const CLI::App& program);

}  // namespace pongsim::fuel
