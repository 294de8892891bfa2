#include "shared/program/command_line.hh"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <new>
#include <sstream>
#include <utility>

#include "pongsim/program/keystore.hh"
#include "pongsim/program/nearest_word.hh"
#include "shared/program/console.hh"
#include "shared/program/descriptor.hh"

namespace pongsim::cli {

namespace {

bool isOption(std::string_view word) { return word.size() > 1 && word.starts_with('-'); }

/// @return The command that the user named, or the program itself.
const CLI::App& namedCommand(const CLI::App& app) {
  const std::vector<CLI::App*> named = app.get_subcommands();
  return named.empty() ? app : *named.front();
}

/// @return "pongsim log playback --help".
std::string helpFor(const CLI::App& command) {
  const CLI::App* app = command.get_parent();
  return (app == nullptr ? "" : app->get_name() + " ") + command.get_name() + " --help";
}

const char* kindOf(const Program& program) { return program.hasActions ? "action" : "command"; }

/// @return "pongsim --help lists the commands".
std::string whereListed(const CLI::App& app, const Program& program) {
  return helpFor(app) + (program.hasActions ? " lists them" : " lists the commands");
}

/// @param what "option".
/// @param otherwise The hint if no known word resembles the unknown one.
UsageError unknown(const char* what, const std::string& word, const std::vector<std::string>& known,
                   const std::string& command, const std::string& otherwise, const Program& program) {
  const std::vector<std::string_view> words(known.begin(), known.end());
  if (program.advice != nullptr) {
    if (auto advice = program.advice(command, word, words)) return *advice;
  }
  const std::string near = didYouMean(word, words);
  return UsageError("unknown " + std::string(what) + " '" + word + "'", near.empty() ? otherwise : near);
}

UsageError unknownOption(const CLI::App& command, const std::string& option, const Program& program) {
  std::vector<std::string> known;
  for (const CLI::Option* each : command.get_options()) {
    for (const std::string& name : each->get_lnames()) known.push_back("--" + name);
  }
  return unknown("option", option, known, command.get_name(), helpFor(command) + " lists the options", program);
}

UsageError unknownCommand(const CLI::App& app, const std::string& name, const Program& program) {
  std::vector<std::string> known;
  for (const CLI::App* each : app.get_subcommands({})) {
    if (!each->get_group().empty()) known.push_back(each->get_name());
  }
  return unknown(kindOf(program), name, known, {}, whereListed(app, program), program);
}

/// @return The word that the user meant as a command, if there is none with this name.
std::optional<std::string> wrongCommand(const CLI::App& app) {
  if (!app.get_subcommands().empty()) return std::nullopt;
  const std::vector<std::string> extras = app.remaining();
  const auto name = std::ranges::find_if_not(extras, isOption);
  return name == extras.end() ? std::nullopt : std::optional(*name);
}

/// Rewords CLI11's error.
UsageError explain(const CLI::App& app, const CLI::ParseError& error, const Program& program) {
  if (const auto name = wrongCommand(app)) return unknownCommand(app, *name, program);
  const CLI::App& command = namedCommand(app);
  const std::vector<std::string> extras = app.remaining(true);
  const auto option = std::ranges::find_if(extras, isOption);
  if (option != extras.end()) return unknownOption(command, option->substr(0, option->find('=')), program);
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

}  // namespace

std::unique_ptr<CLI::App> makeApp(const Program& program, Work& work) {
  auto app = std::make_unique<CLI::App>(program.about, program.name);
  // its commands get the same option
  app->set_help_flag("-h,--help", "Print this help and exit");
  app->footer(program.footer);
  // words after a command belong to it: "pongsim ros2 topic" is not "pongsim topic"
  app->require_subcommand(0, 1);
  for (const AddCommand add : program.commands) add(*app, work);
  if (!program.hasActions) return app;
  for (CLI::App* action : app->get_subcommands({})) {
    if (!action->get_group().empty()) action->group("Actions");
  }
  app->get_formatter()->label("SUBCOMMAND", "ACTION");
  return app;
}

Work workOf(std::vector<std::string> words, const Program& program) {
  const auto work = std::make_shared<Work>();
  const std::shared_ptr<CLI::App> app = makeApp(program, *work);
  const auto nothingGiven = [&] {
    return UsageError("no " + std::string(kindOf(program)) + " given", whereListed(*app, program));
  };
  if (words.empty()) throw nothingGiven();
  if (words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  if (program.hasActions && words.back() == "help") words.back() = "--help";
  if (program.words != nullptr) words = program.words(std::move(words), *app);
  try {
    // CLI11 consumes them from the back
    std::ranges::reverse(words);
    app->parse(std::move(words));
  } catch (const CLI::Success& success) {
    if (const auto name = wrongCommand(*app)) throw unknownCommand(*app, *name, program);
    std::ostringstream text;
    app->exit(success, text, text);
    const int code = print(text.str()) ? kDone : kFailed;
    return [code] { return code; };
  } catch (const CLI::ParseError& error) {
    throw explain(*app, error, program);
  }
  if (!*work) throw nothingGiven();
  // the parsed options are stored in the app
  return [app, work] { return (*work)(); };
}

int reportingFailures(const Work& work) {
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  try {
    return work();
  } catch (const UsageError& error) {
    sayError(error.what(), error.hint());
    return kWrongUsage;
  } catch (const Failure& error) {
    return fail(error.what(), error.hint());
  } catch (const KeystoreError& error) {
    return fail(error.what(), error.hint());
  } catch (const std::bad_alloc&) {
    return fail("not enough memory");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

int run(int argc, char** argv, const Program& program) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  return reportingFailures([&] {
    // for the build: see pongsim_extension in cmake/Targets.cmake
    if (words.size() == 2 && words.front() == "--describe") {
      Work none;
      return print(descriptorWithActions(words.back(), *makeApp(program, none))) ? kDone : kFailed;
    }
    return workOf(std::move(words), program)();
  });
}

}  // namespace pongsim::cli
