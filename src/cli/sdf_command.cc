#include <CLI/App.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hh"
#include "cli/console.hh"
#include "cli/diagnostic_report.hh"
#include "sdf/loader.hh"

namespace pongsim::cli {

namespace {

struct Options {
  std::vector<std::string> files;
  bool check = false;
  bool strict = false;
  bool json = false;
};

/// @return What is wrong with the file, with warnings as errors if the user wants that.
Diagnostics diagnosticsOf(const std::string& file, bool strict) {
  Diagnostics found;
  sdf::loadFile(file, found);
  if (!strict) return found;
  Diagnostics errors;
  for (Diagnostic diagnostic : found.all()) {
    diagnostic.severity = Severity::kError;
    errors.add(std::move(diagnostic));
  }
  return errors;
}

int check(const Options& options) {
  bool areValid = true;
  std::string text;
  std::vector<Diagnostic> all;
  for (const std::string& file : options.files) {
    const Diagnostics diagnostics = diagnosticsOf(file, options.strict);
    areValid = areValid && !diagnostics.hasErrors();
    if (options.json) {
      all.insert(all.end(), diagnostics.all().begin(), diagnostics.all().end());
      continue;
    }
    say(diagnostics, Severity::kWarning, Severity::kWarning);
    // Fortress checks one file at a time and does not name it
    if (!diagnostics.hasErrors()) text += (options.files.size() > 1 ? file + ": " : "") + "Valid.\n";
  }
  if (options.json) text = jsonOf(all);
  const bool isPrinted = text.empty() || print(text);
  return areValid && isPrinted ? kDone : kFailed;
}

void checkAndSchedule(const Options& options, Work& work) {
  if (!options.check) throw UsageError("nothing to do", "pongsim sdf --check FILE");
  if (options.files.empty()) throw UsageError("no file given", "pongsim sdf --check FILE");
  work = [&options] { return check(options); };
}

}  // namespace

void addSdfCommand(CLI::App& program, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("sdf", "Look into world and model files");
  command->set_help_flag("-h,--help", "Print this and end");
  command->add_option("FILE", options->files, "World or model files")->type_name("");
  const auto addFlag = [command](const char* name, bool& target, const char* description) {
    command->add_flag(name, target, description)->disable_flag_override();
  };
  addFlag("-k,--check", options->check, "Say what is wrong with the files and what they include, or 'Valid.'");
  addFlag("--strict", options->strict, "Take warnings for errors");
  addFlag("--json", options->json, "Print what is wrong as an array of JSON objects");
  command->footer(
      "Examples:\n"
      "  pongsim sdf --check worlds/pong_world.sdf\n"
      "  pongsim sdf --check --strict --json worlds/*.sdf");
  command->callback([options, &work] { checkAndSchedule(*options, work); });
}

}  // namespace pongsim::cli
