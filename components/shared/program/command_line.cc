#include "shared/program/command_line.hh"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <sstream>
#include <string_view>

#include "pongsim/program/keystore.hh"
#include "pongsim/program/nearest_word.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::programs {

namespace {

bool isOption(std::string_view word) { return word.size() > 1 && word.starts_with('-'); }

/// The action given by the user, or the program itself.
const CLI::App& namedAction(const CLI::App& program) {
  const std::vector<CLI::App*> named = program.get_subcommands();
  return named.empty() ? program : *named.front();
}

/// @return "pongsim log playback --help".
std::string helpFor(const CLI::App& app) {
  const CLI::App* program = app.get_parent();
  return (program == nullptr ? "" : program->get_name() + " ") + app.get_name() + " --help";
}

UsageError unknown(const std::string& what, const std::string& word, const std::vector<std::string>& known,
                   const std::string& listed) {
  const std::string near = didYouMean(word, std::vector<std::string_view>(known.begin(), known.end()));
  return UsageError("unknown " + what + " '" + word + "'", near.empty() ? listed : near);
}

UsageError unknownOption(const CLI::App& action, const std::string& option) {
  std::vector<std::string> known;
  for (const CLI::Option* each : action.get_options()) {
    for (const std::string& name : each->get_lnames()) known.push_back("--" + name);
  }
  return unknown("option", option, known, helpFor(action) + " lists the options");
}

UsageError unknownAction(const CLI::App& program, const std::string& name) {
  std::vector<std::string> known;
  for (const CLI::App* each : program.get_subcommands({})) {
    if (!each->get_group().empty()) known.push_back(each->get_name());
  }
  return unknown("action", name, known, helpFor(program) + " lists them");
}

/// Rewords CLI11's error.
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

void addActions(CLI::App& app, const Program& program, Work& work) {
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.footer(program.footer);
  // all words after an action belong to it
  app.require_subcommand(0, 1);
  for (const AddAction add : program.actions) add(app, work);
  for (CLI::App* action : app.get_subcommands({})) {
    if (!action->get_group().empty()) action->group("Actions");
  }
  app.get_formatter()->label("SUBCOMMAND", "ACTION");
}

int workOf(std::vector<std::string> words, const Program& program) {
  Work work;
  CLI::App app(program.about, program.name);
  addActions(app, program, work);
  const auto noAction = [&] { return UsageError("no action given", helpFor(app) + " lists them"); };
  if (words.empty()) throw noAction();
  if (program.words != nullptr) words = program.words(std::move(words));
  if (words.front() == "help") std::ranges::rotate(words, words.begin() + 1);
  if (words.back() == "help") words.back() = "--help";
  try {
    // CLI11 expects them in reverse order
    std::ranges::reverse(words);
    app.parse(std::move(words));
  } catch (const CLI::Success& success) {
    std::ostringstream text;
    app.exit(success, text, text);
    return print(text.str());
  } catch (const CLI::ParseError& error) {
    throw explain(app, error);
  }
  if (!work) throw noAction();
  return work();
}

}  // namespace

int run(int argc, char** argv, const Program& program) {
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  try {
    return workOf({argv + std::min(argc, 1), argv + argc}, program);
  } catch (const UsageError& error) {
    sayError(error.what(), error.hint());
    return kWrongUsage;
  } catch (const Failure& error) {
    return fail(error.what(), error.hint());
  } catch (const KeystoreError& error) {
    return fail(error.what(), error.hint());
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

}  // namespace pongsim::programs
