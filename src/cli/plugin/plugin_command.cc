#include <CLI/App.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <variant>
#include <vector>

#include "base/nearest_word.hh"
#include "base/report/crash_report.hh"
#include "cli/command.hh"
#include "cli/plugin/plugin_page.hh"
#include "cli/plugin/plugin_template.hh"
#include "plugin/core_systems.hh"
#include "plugin/fortress_systems.hh"
#include "plugin/inspection.hh"
#include "plugin/loader.hh"
#include "plugin/system_name.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

/// The parsed command line.
struct PluginOptions {
  bool list = false;
  bool missing = false;
  bool later = false;
  bool markdown = false;
  std::optional<std::string> info;
  /// As with `ign plugin`, in addition to --info.
  std::optional<std::string> file;
  std::string newName;
  CLI::App* newCommand = nullptr;
};

int listMissing() {
  std::string text;
  for (const std::string_view name : plugin::missingSystems(plugin::systemsIn(plugin::defaultSearchPath())))
    text += std::string(name) + "\n";
  return print(text) ? kDone : kFailed;
}

/// Prints name, release and whether it is there, one system a line.
int listLater() {
  const std::vector<std::string> available = plugin::systemsIn(plugin::defaultSearchPath());
  std::string text;
  for (const plugin::LaterSystem& system : plugin::laterSystems()) {
    text += std::string(system.name) + "\t" + std::string(system.release) + "\t" +
            (plugin::isSupported(system.name, available) ? "here" : "missing") + "\n";
  }
  return print(text) ? kDone : kFailed;
}

int listPlugins() {
  base::reportCrashes();
  std::string text;
  for (const plugin::CoreSystem& system : plugin::coreSystems()) {
    text += system.name + "\t" + system.className + "\tpart of pongsim itself\n";
  }
  bool areGood = true;
  for (const std::filesystem::path& file : plugin::librariesIn(plugin::defaultSearchPath())) {
    const auto looked = plugin::Inspection::of(file);
    if (const auto* reason = std::get_if<std::string>(&looked)) {
      sayError(file.string() + " can't be used: " + *reason);
      areGood = false;
      continue;
    }
    for (const auto& found : std::get<plugin::Inspection>(looked).classes()) {
      text += plugin::systemName(file.filename().string()) + "\t" + found.names.front() + "\t" + file.string() + "\n";
    }
  }
  return print(text) && areGood ? kDone : kFailed;
}

/// @return The library with this path, or with this name on the search path.
std::filesystem::path libraryNamed(const std::string& name) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(name, ignored)) return name;
  const std::vector<std::filesystem::path> searchPath = plugin::defaultSearchPath();
  if (const auto found = plugin::findLibrary(searchPath, name)) return *found;
  const std::vector<std::string> names = plugin::systemsIn(searchPath);
  const std::string shortName = plugin::systemName(name);
  if (const std::string package(plugin::packageOf(shortName)); !package.empty()) {
    throw UsageError("the system '" + shortName + "' is in the package " + package + ", which is not installed",
                     "apt-get install " + package);
  }
  if (std::ranges::count(plugin::missingSystems(names), shortName) > 0) {
    throw UsageError("the system '" + shortName + "' of Gazebo is not supported yet",
                     "pongsim plugin -l lists what is");
  }
  std::vector<std::string_view> words(names.begin(), names.end());
  for (const plugin::CoreSystem& system : plugin::coreSystems()) words.push_back(system.name);
  std::string hint = base::didYouMean(shortName, words);
  throw UsageError("there is no plugin '" + name + "'", hint.empty() ? "pongsim plugin -l lists them" : hint);
}

template <class Described>
int showPage(const Described& described, bool asMarkdown) {
  return print(asMarkdown ? pluginMarkdown(described) : pluginText(described)) ? kDone : kFailed;
}

int showPlugin(const std::filesystem::path& file, bool asMarkdown) {
  base::reportCrashes();
  const auto looked = plugin::Inspection::of(file);
  if (const auto* reason = std::get_if<std::string>(&looked)) return fail(file.string() + " can't be used: " + *reason);
  return showPage(std::get<plugin::Inspection>(looked), asMarkdown);
}

int makePlugin(const std::string& name) {
  if (const auto error = writePluginTemplate(name, name)) return fail(*error);
  return print("cd " + name + " && cmake -B build && cmake --build build && ctest --test-dir build\n") ? kDone
                                                                                                       : kFailed;
}

Work pluginWork(const PluginOptions& options) {
  const bool makesNew = options.newCommand->parsed();
  if (options.missing && !options.list) throw UsageError("--missing needs --list");
  if (options.later && !options.list) throw UsageError("--later needs --list");
  if (options.later && options.missing) throw UsageError("options '--missing' and '--later' can't be used together");
  if (options.file && !options.info) throw UsageError("--plugin needs --info", "pongsim plugin --info --plugin FILE");
  if (int{options.list} + int{options.info.has_value()} + int{makesNew} != 1) {
    throw UsageError(options.list || options.info ? "only one action at a time" : "no action given",
                     "one of --list, --info FILE and new NAME");
  }
  if (options.info && options.info->empty() == !options.file) {
    throw UsageError(options.file ? "one plugin at a time" : "no plugin given", "pongsim plugin --info FILE|NAME");
  }
  const std::string named = options.file.value_or(options.info.value_or(""));
  if (options.markdown && !options.info) throw UsageError("--markdown needs --info");
  if (options.list) return options.missing ? listMissing : options.later ? listLater : listPlugins;
  if (options.info) {
    if (const plugin::CoreSystem* system = plugin::coreSystem(named)) {
      return [system, asMarkdown = options.markdown] { return showPage(*system, asMarkdown); };
    }
    return [file = libraryNamed(named), asMarkdown = options.markdown] { return showPlugin(file, asMarkdown); };
  }
  if (const auto error = pluginNameError(options.newName)) {
    throw UsageError("'" + options.newName + "' " + *error, "a name such as my-system");
  }
  return [name = options.newName] { return makePlugin(name); };
}

}  // namespace

void addPluginCommand(CLI::App& program, Work& work) {
  const auto options = std::make_shared<PluginOptions>();
  CLI::App* command = program.add_subcommand("plugin", "List systems, describe one, create a new one");
  command->add_flag("-l,--list", options->list, "Print the available systems: name, class and file")
      ->disable_flag_override();
  command->add_flag("--missing", options->missing, "With --list: Gazebo's systems that pongsim lacks")
      ->disable_flag_override();
  command
      ->add_flag("--later", options->later,
                 "With --list: the systems of Gazebo since Garden, and whether they are here")
      ->disable_flag_override();
  command
      ->add_option_function<std::string>(
          "-i,--info", [options](const std::string& text) { options->info = text; },
          "Print a system's classes, parameters, topics and services")
      ->type_name("FILE|NAME")
      ->expected(0, 1);
  command
      ->add_option_function<std::string>(
          "-p,--plugin", [options](const std::string& text) { options->file = text; },
          "With --info, instead of FILE|NAME, like 'ign plugin'")
      ->type_name("FILE|NAME");
  command->add_flag("--markdown", options->markdown, "With --info: print a documentation page")
      ->disable_flag_override();
  options->newCommand = command->add_subcommand("new", "Create a folder with a new system that builds");
  options->newCommand->footer(
      "Examples:\n  pongsim plugin new my-system\n"
      "  cd my-system && cmake -B build && cmake --build build && ctest --test-dir build");
  options->newCommand->add_option("NAME", options->newName, "Name of the folder and the system: my-system")
      ->type_name("")
      ->required();
  command->footer(
      "Examples:\n"
      "  pongsim plugin -l\n"
      "  pongsim plugin -l --missing\n"
      "  pongsim plugin -i diff-drive\n"
      "  pongsim plugin new my-system");
  command->callback([options, &work] { work = pluginWork(*options); });
}

}  // namespace pongsim::cli
