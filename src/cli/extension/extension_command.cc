#include "cli/extension/extension_command.hh"

#include <unistd.h>

#include <CLI/App.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/own_folder.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

/// Replaces this process by the program.
int runProgram(const std::string& name, const std::vector<std::string>& arguments) {
  const std::filesystem::path file = ownFolder().parent_path().parent_path() / "libexec/pongsim" / name;
  std::vector<std::string> words{file.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  execv(file.c_str(), argv.data());
  return fail(file.string() + " can't be run: " + std::strerror(errno));
}

std::string footerOf(const Extension::Command& command) {
  std::string text;
  if (!command.actions.empty()) text += "Actions:\n";
  for (const Extension::Action& action : command.actions) {
    text += "  " + action.name + std::string(action.name.size() < 10 ? 10 - action.name.size() : 1, ' ') + action.help +
            "\n";
  }
  if (!command.examples.empty()) text += std::string(text.empty() ? "" : "\n") + "Examples:\n";
  for (const std::string& example : command.examples) text += "  " + example + "\n";
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace

void addExtensionCommand(CLI::App& program, const Extension::Command& command, Work& work) {
  CLI::App* added = program.add_subcommand(command.name, command.help);
  // the command's own program handles everything after the name, including an action's --help
  added->set_help_flag();
  added->prefix_command();
  added->group(kExtensionGroup);
  added->footer(footerOf(command));
  const std::string name = command.program;
  added->callback(
      [added, name, &work] { work = [name, arguments = added->remaining()] { return runProgram(name, arguments); }; });
}

void addExtensionCommands(CLI::App& program, Work& work) {
  for (const Extension& extension : installedExtensions()) {
    if (extension.command) addExtensionCommand(program, *extension.command, work);
  }
}

std::string extensionWords() {
  std::string text;
  for (const Extension& extension : installedExtensions()) {
    if (!extension.runOptions.empty()) {
      text += "run";
      for (const Extension::Option& option : extension.runOptions) text += " " + option.name;
      text += "\n";
    }
    if (!extension.command) continue;
    text += extension.command->name;
    for (const Extension::Action& action : extension.command->actions) {
      text += " " + action.name;
      for (const Extension::Option& option : action.options) text += " " + option.name;
    }
    text += "\n";
  }
  return text;
}

}  // namespace pongsim::cli
