#pragma once

#include "cli/command.hh"
#include "cli/extension/extension.hh"

namespace pongsim::cli {

/// Adds the commands of all installed extensions, each implemented by its own program.
void addExtensionCommands(CLI::App& program, Work& work);

/// Adds one such command, which must outlive the program.
void addExtensionCommand(CLI::App& program, const Extension::Command& command, Work& work);

/// @return For completion: one line for each command, with the words that may follow it.
std::string extensionWords();

}  // namespace pongsim::cli
