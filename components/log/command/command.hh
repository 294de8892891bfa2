#pragma once

#include "shared/program/command_line.hh"

namespace pongsim::log {

// The actions of `pongsim log` (`cli::AddCommand`), which main.cc lists.
void addPlaybackAction(CLI::App& program, cli::Work& work);
void addWorldAction(CLI::App& program, cli::Work& work);
void addConvertAction(CLI::App& program, cli::Work& work);
void addExportAction(CLI::App& program, cli::Work& work);
void addInfoAction(CLI::App& program, cli::Work& work);
void addRecordAction(CLI::App& program, cli::Work& work);

}  // namespace pongsim::log
