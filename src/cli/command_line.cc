#include "cli/command_line.hh"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <csignal>
#include <cstddef>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/nearest_word.hh"
#include "cli/console.hh"
#include "cli/extension/optional_values.hh"
#include "cli/fortress_words.hh"
#include "cli/ign_arguments.hh"
#include "pongsim/program/keystore.hh"

namespace pongsim::cli {

namespace {

bool isOption(std::string_view word) { return word.size() > 1 && word.starts_with('-'); }

/// @return The subcommand that the user named, or the program itself.
const CLI::App& namedCommand(const CLI::App& program) {
  const std::vector<CLI::App*> named = program.get_subcommands();
  return named.empty() ? program : *named.front();
}

/// @return "pongsim run --help".
std::string helpFor(const CLI::App& command) {
  const CLI::App* program = command.get_parent();
  return (program == nullptr ? "" : program->get_name() + " ") + command.get_name() + " --help";
}

UsageError unknownOption(const CLI::App& command, const std::string& option) {
  std::vector<std::string> known;
  for (const CLI::Option* each : command.get_options()) {
    for (const std::string& name : each->get_lnames()) known.push_back("--" + name);
  }
  const std::vector<std::string_view> words(known.begin(), known.end());
  if (const auto advice = adviceOnOption(command.get_name(), option, words))
    return UsageError(advice->message, advice->hint);
  std::string hint = base::didYouMean(option, words);
  if (hint.empty()) hint = helpFor(command) + " lists the options";
  return UsageError("unknown option '" + option + "'", hint);
}

UsageError unknownCommand(const CLI::App& program, const std::string& name) {
  if (const auto advice = adviceOnCommand(name)) return UsageError(advice->message, advice->hint);
  std::vector<std::string_view> known;
  for (const CLI::App* each : program.get_subcommands({})) known.push_back(each->get_name());
  std::string hint = base::didYouMean(name, known);
  if (hint.empty()) hint = "pongsim --help lists the commands";
  return UsageError("unknown command '" + name + "'", hint);
}

/// @return The word that the user meant as a command, if there is none with this name.
std::optional<std::string> wrongCommand(const CLI::App& program) {
  if (!program.get_subcommands().empty()) return std::nullopt;
  for (const std::string& extra : program.remaining()) {
    if (!isOption(extra)) return extra;
  }
  return std::nullopt;
}

/// Rewords CLI11's errors.
UsageError explain(const CLI::App& program, const CLI::ParseError& error) {
  if (const auto name = wrongCommand(program)) return unknownCommand(program, *name);
  const CLI::App& command = namedCommand(program);
  const std::vector<std::string> extras = program.remaining(true);
  const auto option = std::find_if(extras.begin(), extras.end(), isOption);
  if (option != extras.end()) return unknownOption(command, option->substr(0, option->find('=')));
  if (!extras.empty()) return UsageError("unexpected argument '" + extras.front() + "'");

  const std::string said = error.what();
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) {
    return UsageError(said, helpFor(command) + " has details");
  }
  std::string name = said.substr(0, said.find_first_of(": "));
  if (!isOption(name)) name.insert(0, name.size() > 1 ? "--" : "-");
  if (said.ends_with("missing")) return UsageError("option '" + name + "' needs a value");
  if (said.find("At Most") != std::string::npos) return UsageError("option '" + name + "' is given twice");
  return UsageError("option '" + name + "' takes no value");
}

/// `pongsim help topic` is `pongsim topic --help`.
IgnLine lineOf(int argc, char** argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  if (argc > 0 && isCalledAsIgn(argv[0])) return fromIgnArguments(arguments);
  if (!arguments.empty() && arguments.front() == "help") {
    arguments.erase(arguments.begin());
    arguments.push_back("--help");
  }
  return {std::move(arguments)};
}

/// @return The exit code, if only text was asked for.
int parse(CLI::App& program, std::vector<std::string> arguments) {
  try {
    // CLI11 consumes them from the back
    std::reverse(arguments.begin(), arguments.end());
    program.parse(std::move(arguments));
  } catch (const CLI::Success& success) {
    if (const auto name = wrongCommand(program)) throw unknownCommand(program, *name);
    std::ostringstream text;
    program.exit(success, text, text);
    return print(text.str()) ? kDone : kFailed;
  } catch (const CLI::ParseError& error) {
    throw explain(program, error);
  }
  return kDone;
}

}  // namespace

std::unique_ptr<CLI::App> makeProgram(std::span<const AddCommand> commands, Work& work) {
  auto program =
      std::make_unique<CLI::App>("pongsim simulates the robots of a Gazebo Fortress world, headless.", "pongsim");
  program->set_help_flag("-h,--help", "Print this help and exit");
  // words after a command belong to it: "pongsim ros2 topic" is not "pongsim topic"
  program->require_subcommand(0, 1);
  program->footer(
      "Examples:\n"
      "  pongsim run worlds/pong_world.sdf\n"
      "  pongsim topic --list\n"
      "  pongsim topic --help\n"
      "\n"
      "Environment:\n"
      "  PONGSIM_DOMAIN         DDS domain, 0 to 232 (0): processes in different domains do not see each other\n"
      "  PONGSIM_NETWORK        network interface for other machines, by name or address\n"
      "  PONGSIM_SECURITY       keystore, or KEYSTORE/NAME, to secure all topics and services\n"
      "  PONGSIM_PLUGIN_PATH    folders of systems, searched before pongsim's own\n"
      "  PONGSIM_RESOURCE_PATH  folders of worlds and models");
  for (const AddCommand add : commands) add(*program, work);
  return program;
}

Work workOf(int argc, char** argv, std::span<const AddCommand> commands) {
  const auto work = std::make_shared<Work>();
  const std::shared_ptr<CLI::App> program = makeProgram(commands, *work);
  const IgnLine line = lineOf(argc, argv);
  if (line.text) return [text = *line.text] { return print(text) ? kDone : kFailed; };
  if (line.arguments.empty()) throw UsageError("no command given", "pongsim --help lists the commands");
  const int done = parse(*program, withOptionalValuesLast(line.arguments, *program));
  // the parsed options are stored in the program
  return [program, work, done] { return *work ? (*work)() : done; };
}

int run(int argc, char** argv, std::span<const AddCommand> commands) {
  // a closed pipe is noticed when writing
  std::signal(SIGPIPE, SIG_IGN);
  // and so is a file that reaches its size limit
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return workOf(argc, argv, commands)();
  } catch (const UsageError& error) {
    sayError(error.what(), error.hint());
    return kWrongUsage;
  } catch (const KeystoreError& error) {
    return fail(error.what(), error.hint());
  } catch (const std::bad_alloc&) {
    return fail("not enough memory");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

}  // namespace pongsim::cli
