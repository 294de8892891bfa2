#include <CLI/App.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "assets/finder.hh"
#include "cli/command.hh"
#include "cli/files/diagnostic_report.hh"
#include "cli/files/world_file.hh"
#include "cli/options/number_option.hh"
#include "cli/options/offline_option.hh"
#include "cli/options/xacro_options.hh"
#include "cli/sdf/inertial_stats.hh"
#include "cli/sdf/sdf_describe.hh"
#include "cli/sdf/sdf_schema_text.hh"
#include "plugin/world_check.hh"
#include "pongsim/files/fuel_address.hh"
#include "sdf/loader.hh"
#include "sdf/schema/rounding.hh"
#include "sdf/text/computed_inertia.hh"
#include "sdf/text/degrees.hh"
#include "sdf/text/print.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

/// What --describe prints without a name: the version of Fortress.
constexpr const char* kDescribedSdf = "1.9";

struct SdfOptions {
  std::vector<std::string> files;
  bool check = false;
  bool strict = false;
  bool json = false;
  bool print = false;
  std::optional<std::string> graph;
  std::optional<std::string> element;
  bool preserveIncludes = false;
  bool degrees = false;
  bool expandsInertia = false;
  std::optional<std::string> snap, tolerance, precision;
  /// A model file.
  std::optional<std::string> inertia;

  bool turnsToDegrees() const { return degrees || snap || tolerance; }
  bool changesPrint() const { return preserveIncludes || turnsToDegrees() || expandsInertia || precision; }
};

/// @return The file, also for an address on a Fuel server; nothing, with an error, if the address leads nowhere.
std::optional<std::filesystem::path> localFile(const std::string& file, Diagnostics& diagnostics) {
  return isFuelAddress(file) ? fetchWorldFile(file, diagnostics) : file;
}

/// @return The file's diagnostics, with warnings as errors if the user wants that.
Diagnostics diagnosticsOf(const std::string& file, bool strict) {
  Diagnostics found;
  if (const auto local = localFile(file, found)) {
    const sdf::Root root = sdf::loadFile(*local, found);
    for (const description::World& world : root.worlds) plugin::checkPlugins(world, found);
    for (const description::Model& model : root.models) plugin::checkPlugins(model, found);
  }
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
    // Fortress checks one file at a time and does not print its name
    if (!diagnostics.hasErrors()) text += (options.files.size() > 1 ? file + ": " : "") + "Valid.\n";
  }
  if (options.json) text = jsonOf(all);
  const bool isPrinted = text.empty() || print(text);
  return areValid && isPrinted ? kDone : kFailed;
}

/// How `--print` changes what it prints.
struct PrintOptions {
  sdf::IncludeUse includes = sdf::IncludeUse::kReplace;
  std::optional<sdf::DegreeOptions> degrees;
  bool expandsInertia = false;
  /// Significant digits.
  std::optional<int> precision;
};

int printResolved(const std::string& file, const PrintOptions& options) {
  Diagnostics diagnostics;
  const auto local = localFile(file, diagnostics);
  std::optional<Element> resolved;
  if (local) resolved = sdf::resolveFile(*local, diagnostics, assets::finderFromEnvironment(), options.includes);
  say(diagnostics, Severity::kWarning, Severity::kWarning);
  if (!resolved) return kFailed;
  if (options.expandsInertia) {
    // the messages are those above
    Diagnostics again;
    sdf::writeComputedInertia(*resolved, sdf::loadFile(*local, again));
  }
  if (options.precision) sdf::roundNumbers(*resolved, *options.precision);
  if (options.degrees) sdf::turnToDegrees(*resolved, *options.degrees);
  return print(sdf::printDocument(*resolved)) ? kDone : kFailed;
}

int printInertialStats(const std::string& file) {
  Diagnostics diagnostics;
  const auto local = localFile(file, diagnostics);
  const sdf::Root root = local ? sdf::loadFile(*local, diagnostics) : sdf::Root();
  say(diagnostics, Severity::kWarning, Severity::kWarning);
  if (diagnostics.hasErrors()) return kFailed;
  if (root.models.empty() || !root.worlds.empty()) {
    return fail("'" + file + "' has " + (root.worlds.empty() ? "no model" : "a world"),
                "--inertial-stats needs a model file");
  }
  const description::Model& model = root.models.front();
  if (!model.models.empty()) say("warning: nested models are not included");
  return print(inertialStats(model)) ? kDone : kFailed;
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

sdf::DegreeOptions degreeOptions(const SdfOptions& options) {
  sdf::DegreeOptions degrees;
  if (options.tolerance && !options.snap) throw UsageError("--snap-tolerance needs --snap-to-degrees");
  if (options.snap) degrees.snapTo = static_cast<int>(wholeNumber("--snap-to-degrees", *options.snap, 1, 360));
  if (options.tolerance)
    degrees.tolerance = numberFromZero("--snap-tolerance", *options.tolerance, "a number of degrees");
  if (options.snap && degrees.tolerance >= degrees.snapTo) {
    throw UsageError("--snap-tolerance must be smaller than --snap-to-degrees");
  }
  return degrees;
}

Work printWork(const SdfOptions& options) {
  PrintOptions print;
  if (options.preserveIncludes) print.includes = sdf::IncludeUse::kPreserve;
  if (options.turnsToDegrees()) print.degrees = degreeOptions(options);
  print.expandsInertia = options.expandsInertia;
  // a double has at most 17 significant digits
  if (options.precision) print.precision = static_cast<int>(wholeNumber("--precision", *options.precision, 1, 17));
  return [file = options.files.front(), print] { return printResolved(file, print); };
}

Work describeWork(const SdfOptions& options) {
  if (const auto version = sdfVersion(options.element->empty() ? kDescribedSdf : *options.element)) {
    if (!options.files.empty()) throw UsageError("--describe takes no file");
    return [version] { return print(schemaText(*version)) ? kDone : kFailed; };
  }
  const std::variant<sdf::NamedPart, sdf::NoPart> found = sdf::findPart(*options.element);
  if (const auto* none = std::get_if<sdf::NoPart>(&found)) throw UsageError(none->message, none->hint);
  if (!options.files.empty()) throw UsageError("--describe takes no file");
  return [text = describe(std::get<sdf::NamedPart>(found))] { return print(text) ? kDone : kFailed; };
}

Work workFor(const SdfOptions& options) {
  const int tasks = int{options.check} + int{options.print} + int{options.graph.has_value()} +
                    int{options.element.has_value()} + int{options.inertia.has_value()};
  if (tasks == 0) throw UsageError("no action given", "pongsim sdf --help lists the actions");
  if (tasks > 1) throw UsageError("only one action at a time", "pongsim sdf --help lists the actions");
  if (!options.check && (options.strict || options.json)) {
    throw UsageError("--strict and --json need --check");
  }
  if (!options.print && options.changesPrint()) {
    throw UsageError(
        "--preserve-includes, --degrees, --snap-..., --precision and --expand-auto-inertials need --print");
  }
  if (options.element) return describeWork(options);
  if (options.inertia) {
    if (!options.files.empty()) throw UsageError("--inertial-stats takes one file");
    return [&options] { return printInertialStats(*options.inertia); };
  }
  const std::string task = options.check ? "--check" : options.print ? "--print" : "--graph " + *options.graph;
  if (options.files.empty()) throw UsageError("no file given", "pongsim sdf " + task + " FILE");
  if (options.check) return [&options] { return check(options); };
  if (options.files.size() > 1) throw UsageError(task + " takes one file");
  if (options.print) return printWork(options);
  return [&options, kind = graphKind(*options.graph)] { return printGraph(options.files.front(), kind); };
}

}  // namespace

void addSdfCommand(CLI::App& program, Work& work) {
  const auto options = std::make_shared<SdfOptions>();
  CLI::App* command = program.add_subcommand("sdf", "Check, print and describe world and model files");
  command->add_option("FILE", options->files, "World or model files; and ARG:=VALUE for those of xacro")->type_name("");
  const auto addFlag = [command](const char* name, bool& target, const char* description) {
    command->add_flag(name, target, description)->disable_flag_override();
  };
  const auto addValue = [command](const char* name, const char* value, const char* description,
                                  std::optional<std::string>& target) {
    command
        ->add_option_function<std::string>(
            name, [&target](const std::string& text) { target = text; }, description)
        ->type_name(value);
  };
  addFlag("-k,--check", options->check, "Report all mistakes in the files and what they include, or print 'Valid.'");
  addFlag("-p,--print", options->print,
          "Print the file as SDF 1.9 (1.12 if it is of 1.10 or later), with includes resolved and default values "
          "filled in");
  addFlag("--strict", options->strict, "Treat warnings as errors");
  addFlag("--json", options->json, "Print mistakes as an array of JSON objects");
  command
      ->add_option_function<std::string>(
          "-g,--graph", [options](const std::string& text) { options->graph = text; },
          "Print a graph for Graphviz: what each frame is attached to, or its pose is relative to")
      ->type_name("frame|pose");
  command
      ->add_option_function<std::string>(
          "-d,--describe", [options](const std::string& text) { options->element = text; },
          "Describe an element or attribute of the format: joint, joint/axis/limit, joint/@type;\n"
          "without one, print all of SDF 1.9 or of that VERSION")
      ->type_name("[ELEMENT|VERSION]")
      ->expected(0, 1);
  addValue("--inertial-stats", "MODEL_FILE",
           "Print total mass, centre of mass and inertia of a model's links, in its frame", options->inertia);
  addFlag("-i,--preserve-includes", options->preserveIncludes, "Print: keep each <include>");
  addFlag("--degrees", options->degrees, "Print: rotations in degrees");
  addValue("--snap-to-degrees", "N",
           "Print: rotations in degrees, rounded to multiples of N degrees, 1 to 360, if near one", options->snap);
  addValue("--snap-tolerance", "X", "How near counts, in degrees (0.01)", options->tolerance);
  addValue("--precision", "N", "Print: numbers with N significant digits, 1 to 17", options->precision);
  addFlag("--expand-auto-inertials", options->expandsInertia,
          "Print: with the mass and inertia that <inertial auto='true'> has");
  CLI::Option* offline = addOfflineOption(*command);
  CLI::Option* packages = addPackagesOption(*command);
  command->footer(
      "Examples:\n"
      "  pongsim sdf --check worlds/pong_world.sdf\n"
      "  pongsim sdf --print worlds/pong_world.sdf\n"
      "  pongsim sdf --print --degrees worlds/pong_world.sdf\n"
      "  pongsim sdf --graph pose worlds/pong_world.sdf | dot -Tsvg > frames.svg\n"
      "  pongsim sdf --describe joint/axis/limit\n"
      "  pongsim sdf --check --strict --json worlds/*.sdf");
  command->callback([options, offline, packages, &work] {
    if (options->element && offline->count() > 0) throw UsageError("--offline needs a file");
    if (options->element && packages->count() > 0) throw UsageError("--packages needs a file");
    const auto arguments = std::ranges::stable_partition(options->files, std::not_fn(isXacroArgument));
    passToXacro({arguments.begin(), arguments.end()});
    options->files.erase(arguments.begin(), arguments.end());
    work = workFor(*options);
  });
}

}  // namespace pongsim::cli
