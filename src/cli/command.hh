#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace pongsim::cli {

/// The work to do after the command line has been parsed.
/// @return The exit code.
using Work = std::function<int()>;

/// Each function adds its subcommand (the first one an option) to `program`. The subcommand sets `work` if the user
/// names it. Both must outlive the work.
void addVersionOption(CLI::App& program, Work& work);
/// With the options of installed extensions.
void addRunCommand(CLI::App& program, Work& work);
/// Without them.
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
