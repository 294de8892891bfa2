#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace pongsim::cli {

/// What is to be done once the command line has been read.
/// @return The exit code.
using Work = std::function<int()>;

/// Reads a whole command line, of which the program's name is the first word; does nothing yet, but that it prints help
/// where that is asked for.
/// @throws UsageError where it is wrong.
Work workOf(int argc, char** argv);

/// Each adds its subcommand to `program`, which sets `work` where the user names it. Both must stay until the work
/// is done.
void addRunCommand(CLI::App& program, Work& work);
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
