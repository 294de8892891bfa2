#pragma once

#include "shared/program/command_line.hh"

namespace pongsim::security {

/// Adds the actions of `pongsim security`.
void addActions(CLI::App& program, cli::Work& work);

}  // namespace pongsim::security
