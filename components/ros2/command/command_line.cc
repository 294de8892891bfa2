#include "ros2/command/command_line.hh"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/program/keystore.hh"
#include "pongsim/program/nearest_word.hh"
#include "ros2/command/console.hh"

namespace pongsim::ros2 {

namespace {

// Where it is called, as the user sees it.
constexpr const char* kName = "pongsim ros2";

bool isOption(std::string_view word) { return word.size() > 1 && word.starts_with('-'); }

std::string hintOr(std::string_view word, const std::vector<std::string>& known, std::string otherwise) {
  std::string hint = didYouMean(word, std::vector<std::string_view>(known.begin(), known.end()));
  return hint.empty() ? otherwise : hint;
}

/// The action that the user named, or the program itself.
const CLI::App& namedAction(const CLI::App& program) {
  const std::vector<CLI::App*> named = program.get_subcommands();
  return named.empty() ? program : *named.front();
}

/// @return "pongsim ros2 topics --help".
std::string helpFor(const CLI::App& app) {
  return std::string(kName) + (app.get_parent() == nullptr ? "" : " " + app.get_name()) + " --help";
}

UsageError unknownOption(const CLI::App& action, const std::string& option) {
  std::vector<std::string> known;
  for (const CLI::Option* each : action.get_options()) {
    for (const std::string& name : each->get_lnames()) known.push_back("--" + name);
  }
  return UsageError("unknown option '" + option + "'", hintOr(option, known, helpFor(action) + " lists the options"));
}

UsageError unknownAction(const CLI::App& program, const std::string& name) {
  std::vector<std::string> known;
  for (const CLI::App* each : program.get_subcommands({})) known.push_back(each->get_name());
  return UsageError("unknown action '" + name + "'", hintOr(name, known, helpFor(program) + " lists them"));
}

/// Says in our words what CLI11 found wrong.
UsageError explain(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App& action = namedAction(program);
  const std::vector<std::string> extras = program.remaining(true);
  if (&action == &program) {
    const auto name = std::ranges::find_if_not(extras, isOption);
    if (name != extras.end()) return unknownAction(program, *name);
  }
  const auto option = std::ranges::find_if(extras, isOption);
  if (option != extras.end()) return unknownOption(action, option->substr(0, option->find('=')));
  if (!extras.empty()) return UsageError("unexpected argument '" + extras.front() + "'");

  const std::string said = error.what();
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) {
    return UsageError(said, helpFor(action) + " has details");
  }
  std::string name = said.substr(0, said.find_first_of(": "));
  if (!isOption(name)) name.insert(0, name.size() > 1 ? "--" : "-");
  if (said.ends_with("missing")) return UsageError("option '" + name + "' needs a value");
  if (said.find("At Most") != std::string::npos) return UsageError("option '" + name + "' is given twice");
  return UsageError("option '" + name + "' takes no value");
}

int workOf(int argc, char** argv, std::span<const AddAction> actions) {
  Work work;
  CLI::App program("Inspects ROS 2 nodes, and what a simulation bridges to them.", kName);
  program.set_help_flag("-h,--help", "Print this help and exit");
  program.footer(
      "Environment:\n"
      "  ROS_DOMAIN_ID       ROS domain, 0 to 232 (0)\n"
      "  ROS_DISTRO          ROS distribution of the nodes: humble (default), jazzy...\n"
      "  ROS_LOCALHOST_ONLY  1: only nodes that use 127.0.0.1");
  for (const AddAction add : actions) add(program, work);
  for (CLI::App* action : program.get_subcommands({})) action->group("Actions");
  program.get_formatter()->label("SUBCOMMAND", "ACTION");
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  if (arguments.empty()) throw UsageError("no action given", helpFor(program) + " lists them");
  if (arguments.front() == "create") arguments = wordsOfCreate(arguments);
  if (arguments.front() == "help") std::ranges::rotate(arguments, arguments.begin() + 1);
  if (arguments.back() == "help") arguments.back() = "--help";
  try {
    // CLI11 takes them from the back
    std::ranges::reverse(arguments);
    program.parse(std::move(arguments));
  } catch (const CLI::Success& success) {
    std::ostringstream text;
    program.exit(success, text, text);
    return print(text.str());
  } catch (const CLI::ParseError& error) {
    throw explain(program, error);
  }
  if (!work) throw UsageError("no action given", helpFor(program) + " lists them");
  return work();
}

}  // namespace

int run(int argc, char** argv, std::span<const AddAction> actions) {
  // a reader that goes away is seen where the writing is done
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return workOf(argc, argv, actions);
  } catch (const UsageError& error) {
    sayError(error.what(), error.hint());
    return kWrongUsage;
  } catch (const KeystoreError& error) {
    return fail(error.what(), error.hint());
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

}  // namespace pongsim::ros2
