#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace pongsim::cli {

/// What is to be done once the command line has been read.
/// @return The exit code.
using Work = std::function<int()>;

/// Each adds its subcommand (the first an option) to `program`, which sets `work` where the user names it. Both must
/// stay until the work is done.
void addVersionOption(CLI::App& program, Work& work);
/// With what installed extensions add to it.
void addRunCommand(CLI::App& program, Work& work);
/// Without.
void addPlainRunCommand(CLI::App& program, Work& work);
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

}  // namespace pongsim::cli
