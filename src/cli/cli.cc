#include "cli/cli.hh"

#include "cli/command.hh"
#include "cli/command_line.hh"

namespace pongsim::cli {

namespace {

constexpr AddCommand kCommands[] = {addRunCommand,   addTopicCommand,  addServiceCommand,   addModelCommand,
                                    addWorldCommand, addKeyCommand,    addViewCommand,      addMsgCommand,
                                    addSdfCommand,   addPluginCommand, addCompletionCommand};

}  // namespace

Work workOf(int argc, char** argv) { return workOf(argc, argv, kCommands); }

int run(int argc, char** argv) { return run(argc, argv, kCommands); }

}  // namespace pongsim::cli

int pongsim_main(int argc, char** argv) { return pongsim::cli::run(argc, argv); }
