#pragma once

#include "shared/program/command_line.hh"

namespace pongsim::cli {

// The commands (`AddCommand`); the first one is an option.
void addVersionOption(CLI::App& program, Work& work);
/// With the options of installed extensions.
void addRunCommand(CLI::App& program, Work& work);
/// Without them.
void addPlainRunCommand(CLI::App& program, Work& work);
void addReplayCommand(CLI::App& program, Work& work);
void addBisectCommand(CLI::App& program, Work& work);
void addSdfCommand(CLI::App& program, Work& work);
void addCompletionCommand(CLI::App& program, Work& work);
void addTopicCommand(CLI::App& program, Work& work);
void addServiceCommand(CLI::App& program, Work& work);
void addModelCommand(CLI::App& program, Work& work);
void addWorldCommand(CLI::App& program, Work& work);
void addKeyCommand(CLI::App& program, Work& work);
void addPluginCommand(CLI::App& program, Work& work);
void addMsgCommand(CLI::App& program, Work& work);
void addViewCommand(CLI::App& program, Work& work);
void addDatasetCommand(CLI::App& program, Work& work);

}  // namespace pongsim::cli
