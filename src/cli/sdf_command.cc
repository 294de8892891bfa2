#include <CLI/App.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/command.hh"
#include "cli/console.hh"
#include "cli/diagnostic_report.hh"
#include "cli/offline_option.hh"
#include "cli/sdf_describe.hh"
#include "cli/world_file.hh"
#include "pongsim/fuel_address.hh"
#include "sdf/loader.hh"
#include "sdf/print.hh"

namespace pongsim::cli {

namespace {

struct SdfOptions {
  std::vector<std::string> files;
  bool check = false;
  bool strict = false;
  bool json = false;
  bool print = false;
  std::optional<std::string> graph;
  std::optional<std::string> element;
};

/// @return The file, which may be the address of one on a Fuel server; nothing, and an error added, where that leads
/// nowhere.
std::optional<std::filesystem::path> localFile(const std::string& file, Diagnostics& diagnostics) {
  return isFuelAddress(file) ? fetchWorldFile(file, diagnostics) : file;
}

/// @return What is wrong with the file, with warnings as errors if the user wants that.
Diagnostics diagnosticsOf(const std::string& file, bool strict) {
  Diagnostics found;
  if (const auto local = localFile(file, found)) sdf::loadFile(*local, found);
  return strict ? asErrors(found) : found;
}

int check(const SdfOptions& options) {
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

int printResolved(const std::string& file) {
  Diagnostics diagnostics;
  const auto local = localFile(file, diagnostics);
  const std::optional<Element> resolved = local ? sdf::resolveFile(*local, diagnostics) : std::nullopt;
  say(diagnostics, Severity::kWarning, Severity::kWarning);
  return resolved && print(sdf::printDocument(*resolved)) ? kDone : kFailed;
}

int printGraph(const std::string& file, sdf::FrameGraphKind kind) {
  Diagnostics diagnostics;
  const auto local = localFile(file, diagnostics);
  const std::optional<std::string> graphs = local ? sdf::frameGraphs(*local, kind, diagnostics) : std::nullopt;
  say(diagnostics, Severity::kWarning, Severity::kWarning);
  return graphs && print(*graphs) ? kDone : kFailed;
}

sdf::FrameGraphKind graphKind(const std::string& name) {
  if (name == "frame") return sdf::FrameGraphKind::kFrame;
  if (name == "pose") return sdf::FrameGraphKind::kPose;
  throw UsageError("'" + name + "' is not a kind of graph", "the kinds are frame and pose");
}

Work describeWork(const SdfOptions& options) {
  const std::variant<sdf::NamedPart, sdf::NoPart> found = sdf::findPart(*options.element);
  if (const auto* none = std::get_if<sdf::NoPart>(&found)) throw UsageError(none->message, none->hint);
  if (!options.files.empty()) throw UsageError("--describe takes no file");
  return [text = describe(std::get<sdf::NamedPart>(found))] { return print(text) ? kDone : kFailed; };
}

Work workFor(const SdfOptions& options) {
  const int tasks = static_cast<int>(options.check) + static_cast<int>(options.print) +
                    static_cast<int>(options.graph.has_value()) + static_cast<int>(options.element.has_value());
  if (tasks == 0) throw UsageError("nothing to do", "pongsim sdf --help lists what there is");
  if (tasks > 1) throw UsageError("one thing at a time", "pongsim sdf --help lists what there is");
  if (!options.check && (options.strict || options.json)) {
    throw UsageError("--strict and --json are for --check");
  }
  if (options.element) return describeWork(options);
  const std::string task = options.check ? "--check" : options.print ? "--print" : "--graph " + *options.graph;
  if (options.files.empty()) throw UsageError("no file given", "pongsim sdf " + task + " FILE");
  if (options.check) return [&options] { return check(options); };
  if (options.files.size() > 1) throw UsageError(task + " takes one file");
  if (options.print) return [&options] { return printResolved(options.files.front()); };
  return [&options, kind = graphKind(*options.graph)] { return printGraph(options.files.front(), kind); };
}

}  // namespace

void addSdfCommand(CLI::App& program, Work& work) {
  const auto options = std::make_shared<SdfOptions>();
  CLI::App* command = program.add_subcommand("sdf", "Look into world and model files, and what they may hold");
  command->set_help_flag("-h,--help", "Print this and end");
  command->add_option("FILE", options->files, "World or model files")->type_name("");
  const auto addFlag = [command](const char* name, bool& target, const char* description) {
    command->add_flag(name, target, description)->disable_flag_override();
  };
  addFlag("-k,--check", options->check, "Say what is wrong with the files and what they include, or 'Valid.'");
  addFlag("-p,--print", options->print, "Print the file as SDF 1.9, with what it includes in place of each <include>");
  addFlag("--strict", options->strict, "Take warnings for errors");
  addFlag("--json", options->json, "Print what is wrong as an array of JSON objects");
  command
      ->add_option_function<std::string>(
          "-g,--graph", [options](const std::string& text) { options->graph = text; },
          "Print a graph for Graphviz: what each frame is attached to, or measured in")
      ->type_name("frame|pose");
  command
      ->add_option_function<std::string>(
          "-d,--describe", [options](const std::string& text) { options->element = text; },
          "Print what the format says of an element or attribute: joint, joint/axis/limit, joint/@type")
      ->type_name("ELEMENT");
  CLI::Option* offline = addOfflineOption(*command);
  command->footer(
      "Examples:\n"
      "  pongsim sdf --check worlds/pong_world.sdf\n"
      "  pongsim sdf --print worlds/pong_world.sdf\n"
      "  pongsim sdf --graph pose worlds/pong_world.sdf | dot -Tsvg > frames.svg\n"
      "  pongsim sdf --describe joint/axis/limit\n"
      "  pongsim sdf --check --strict --json worlds/*.sdf");
  command->callback([options, offline, &work] {
    if (options->element && offline->count() > 0) throw UsageError("--offline goes with a file");
    work = workFor(*options);
  });
}

}  // namespace pongsim::cli
