#pragma once

#include "shared/program/command_line.hh"

namespace pongsim::security {

/// Adds the actions of `pongsim security`. They are also listed in share/security.json, for help and completion.
void addActions(CLI::App& program, cli::Work& work);

}  // namespace pongsim::security
