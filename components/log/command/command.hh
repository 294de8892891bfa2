#pragma once

#include "shared/program/command_line.hh"

namespace pongsim::log {

// The actions of `pongsim log` (`programs::AddAction`). Each is also listed in main.cc, and in share/log.json for help
// and completion.
void addPlaybackAction(CLI::App& program, programs::Work& work);
void addWorldAction(CLI::App& program, programs::Work& work);
void addConvertAction(CLI::App& program, programs::Work& work);
void addExportAction(CLI::App& program, programs::Work& work);
void addInfoAction(CLI::App& program, programs::Work& work);
void addRecordAction(CLI::App& program, programs::Work& work);

}  // namespace pongsim::log
