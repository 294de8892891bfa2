#include "cli/help/manual.hh"

#include <CLI/App.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

#include "cli/extension/extension_command.hh"

namespace pongsim::cli {

namespace {

/// @return The text, escaped for troff.
std::string troff(std::string_view text) {
  std::string result;
  bool isLineStart = true;
  for (const char letter : text) {
    if (isLineStart && (letter == '.' || letter == '\'')) result += "\\&";
    if (letter == '-') {
      result += "\\-";
    } else if (letter == '\\') {
      result += "\\e";
    } else {
      result += letter;
    }
    isLineStart = letter == '\n';
  }
  return result;
}

std::string bold(std::string_view text) { return "\\fB" + troff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + troff(text) + "\\fR"; }

bool isShown(const CLI::Option& option) { return !option.get_group().empty(); }

/// @return "-t, --topic TOPIC", or the name of an argument.
std::string optionHead(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames()) names += (names.empty() ? "" : ", ") + bold("-" + name);
  for (const std::string& name : option.get_lnames()) names += (names.empty() ? "" : ", ") + bold("--" + name);
  if (names.empty()) return italic(option.get_name());
  return option.get_type_name().empty() ? names : names + " " + italic(option.get_type_name());
}

std::string optionsOf(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (isShown(*option)) text += ".TP\n" + optionHead(*option) + "\n" + troff(option->get_description()) + "\n";
  }
  return text;
}

/// @return "[OPTIONS] WORLD".
std::string argumentsOf(const CLI::App& command) {
  std::string text = " [" + italic("OPTIONS") + "]";
  for (const CLI::Option* option : command.get_options()) {
    if (!isShown(*option) || !option->get_positional()) continue;
    const std::string name = italic(option->get_name());
    text += option->get_required() ? " " + name : " [" + name + "]";
  }
  return text;
}

std::vector<const CLI::App*> commandsOf(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// Turns the paragraphs below the options, which begin with "Examples:" or the like, into sections.
std::string sectionsOf(const std::string& footer) {
  std::istringstream lines(footer);
  std::string text;
  bool isOpen = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    if (line.back() == ':' && line.front() != ' ') {
      line.pop_back();
      for (char& letter : line) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
      text += (isOpen ? ".fi\n" : "") + (".SH " + line) + "\n.nf\n";
      isOpen = true;
    } else {
      text += troff(line.substr(std::min(line.find_first_not_of(' '), line.size()))) + "\n";
    }
  }
  return isOpen ? text + ".fi\n" : text;
}

/// @param name As typed: "pongsim run".
std::string page(const CLI::App& command, const std::string& name, const std::string& commands,
                 const std::string& seeAlso) {
  std::string title = name, capitals;
  for (char& letter : title) {
    if (letter == ' ') letter = '-';
    capitals += static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  }
  std::string words = command.get_description();
  std::string brief = words;
  if (brief.starts_with(name + " ")) brief.erase(0, name.size() + 1);
  if (!brief.empty() && brief.back() == '.') brief.pop_back();
  if (!brief.empty()) brief[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(brief[0])));
  return ".TH " + capitals + " 1 \"\" \"pongsim " PONGSIM_VERSION "\" \"pongsim\"\n.SH NAME\n" + troff(title) +
         " \\- " + troff(brief) + "\n.SH SYNOPSIS\n" + bold(name) +
         (commands.empty() ? argumentsOf(command) : " " + italic("COMMAND") + argumentsOf(command)) + "\n" +
         (commands.empty() ? "" : ".SH COMMANDS\n" + commands) + ".SH OPTIONS\n" + optionsOf(command) +
         sectionsOf(command.get_footer()) +
         ".SH EXIT STATUS\n.TP\n0\nSuccess.\n.TP\n1\nFailure, such as errors in a file, no subscriber or no "
         "response.\n.TP\n2\nUsage error.\n.SH SEE ALSO\n" +
         seeAlso + "\n";
}

std::string pageName(const std::string& command) { return bold("pongsim-" + command) + "(1)"; }

/// The subcommands of a command, listed on its page.
std::string nestedCommands(const CLI::App& command) {
  std::string text;
  for (const CLI::App* nested : commandsOf(command)) {
    text += ".TP\n" + bold(command.get_name() + " " + nested->get_name()) + argumentsOf(*nested) + "\n" +
            troff(nested->get_description()) + "\n.RS\n" + optionsOf(*nested) + ".RE\n";
  }
  return text;
}

}  // namespace

std::vector<ManualPage> manualPages(const CLI::App& program) {
  std::vector<ManualPage> pages;
  std::string commands, all;
  for (const CLI::App* command : commandsOf(program)) {
    const std::string& name = command->get_name();
    commands += ".TP\n" + pageName(name) + "\n" + troff(command->get_description()) + "\n";
    all += (all.empty() ? "" : ",\n") + pageName(name);
    const std::string nested = nestedCommands(*command);
    pages.push_back({"pongsim-" + name + ".1", page(*command, "pongsim " + name, {}, bold("pongsim") + "(1)")});
    if (!nested.empty()) pages.back().text.insert(pages.back().text.find(".SH OPTIONS"), ".SH COMMANDS\n" + nested);
  }
  pages.push_back({"pongsim.1", page(program, "pongsim", commands, all)});
  return pages;
}

ManualPage extensionPage(const Extension& extension, const std::string& name) {
  CLI::App program("", "pongsim");
  CLI::App* run = program.add_subcommand("run", "");
  run->set_help_flag();
  RunAdditions additions;
  addRunOptions(*run, extension, additions);
  const Extension::Command command =
      extension.command.value_or(Extension::Command{name, "options of pongsim run", {}, {}, {}});
  Work none;
  addExtensionCommand(program, command, none);
  std::string text = page(*program.get_subcommand(command.name), "pongsim " + command.name, {},
                          bold("pongsim") + "(1), " + pageName("run"));
  std::string sections;
  if (!extension.runOptions.empty()) sections += ".SH OPTIONS OF PONGSIM RUN\n" + optionsOf(*run);
  for (const Extension::Action& action : command.actions) {
    sections += ".SH " + bold("pongsim " + command.name + " " + action.name) + "\n" + troff(action.help) + "\n";
    for (const Extension::Option& option : action.options) {
      sections += ".TP\n" + bold(option.name) + (option.value.empty() ? "" : " " + italic(option.value)) + "\n" +
                  troff(option.help) + "\n";
    }
  }
  text.insert(text.find(".SH EXIT STATUS"), sections);
  return {"pongsim-" + command.name + ".1", text};
}

bool writeManual(const std::vector<ManualPage>& pages, const std::string& folder) {
  for (const ManualPage& page : pages) {
    std::ofstream stream(std::filesystem::path(folder) / page.file, std::ios::binary);
    stream << page.text;
    if (!stream.flush()) return false;
  }
  return true;
}

}  // namespace pongsim::cli
