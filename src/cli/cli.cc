#include "cli/cli.hh"

#include <CLI/App.hpp>
#include <filesystem>
#include <string>

#include "cli/command.hh"
#include "cli/command_line.hh"
#include "cli/extension/extension_command.hh"
#include "cli/help/manual.hh"

namespace pongsim::cli {

namespace {

constexpr AddCommand kCommands[] = {addVersionOption, addRunCommand,     addReplayCommand,     addBisectCommand,
                                    addTopicCommand,  addServiceCommand, addModelCommand,      addWorldCommand,
                                    addKeyCommand,    addViewCommand,    addDatasetCommand,    addMsgCommand,
                                    addSdfCommand,    addPluginCommand,  addCompletionCommand, addExtensionCommands};

/// Commands that do not depend on installed extensions.
constexpr AddCommand kOwnCommands[] = {addVersionOption, addPlainRunCommand, addReplayCommand,    addBisectCommand,
                                       addTopicCommand,  addServiceCommand,  addModelCommand,     addWorldCommand,
                                       addKeyCommand,    addViewCommand,     addDatasetCommand,   addMsgCommand,
                                       addSdfCommand,    addPluginCommand,   addCompletionCommand};

}  // namespace

Work workOf(int argc, char** argv) { return workOf(argc, argv, kCommands); }

int run(int argc, char** argv) { return run(argc, argv, kCommands); }

}  // namespace pongsim::cli

bool pongsim_write_manual(const char* folder) {
  pongsim::cli::Work none;
  const auto program = pongsim::cli::makeApp(pongsim::cli::programWith(pongsim::cli::kOwnCommands), none);
  return pongsim::cli::writeManual(pongsim::cli::manualPages(*program), folder);
}

bool pongsim_write_extension_manual(const char* descriptor, const char* folder) {
  using namespace pongsim::cli;
  const std::string name = std::filesystem::path(descriptor).stem().string();
  return writeManual({extensionPage(readExtension(descriptor), name)}, folder);
}

int pongsim_main(int argc, char** argv) { return pongsim::cli::run(argc, argv); }
