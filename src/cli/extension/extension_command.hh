#pragma once

#include "cli/command.hh"
#include "cli/extension/extension.hh"

namespace pongsim::cli {

/// Adds the commands of all installed extensions, each done by its own program.
void addExtensionCommands(CLI::App& program, Work& work);

/// Adds the command of one of them, which must outlive the program.
void addExtensionCommand(CLI::App& program, const Extension::Command& command, Work& work);

/// @return For completion: a line for each command, with the words that may follow it.
std::string extensionWords();

}  // namespace pongsim::cli
