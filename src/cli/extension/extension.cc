#include "cli/extension/extension.hh"

#include <CLI/App.hpp>
#include <algorithm>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "cli/own_folder.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

using Descriptor = nlohmann::json;

/// @return Whether these are CLI11's values for an option whose value was left out.
bool isLeftOut(const std::vector<std::string>& values) {
  return values.size() == 1 && (values.front().empty() || values.front() == "true");
}

/// @throws std::runtime_error if a program's name leads out of the folder of programs.
std::string plainProgram(std::string name) {
  if (name.find('/') != std::string::npos) throw std::runtime_error("its program is not a plain name");
  return name;
}

Extension::System readSystem(const Descriptor& json) {
  return {json.at("filename").get<std::string>(), json.at("name").get<std::string>()};
}

Extension::Option readOption(const Descriptor& json) {
  Extension::Option option;
  option.name = json.at("option").get<std::string>();
  option.help = json.at("help").get<std::string>();
  option.value = json.value("value", "");
  option.isValueOptional = json.value("optional", false);
  option.allowed = ExtensionValue(json);
  if (option.value.empty() && option.allowed.isLimited())
    throw std::runtime_error("option '" + option.name + "' has a type of value, but no value");
  if (option.isValueOptional && !option.allowed.isNumber())
    throw std::runtime_error("option '" + option.name + "' has an optional value that is not a number");
  option.element = json.value("element", "");
  option.fixed = json.value("sets", "");
  option.isRepeated = json.value("repeated", false);
  option.isFile = json.value("file", false);
  for (const Descriptor& each : json.value("implies", Descriptor::array()))
    option.implied.push_back({each.at("element").get<std::string>(), each.at("sets").get<std::string>()});
  if (const auto system = json.find("system"); system != json.end()) option.system = readSystem(*system);
  if (const auto world = json.find("world"); world != json.end()) {
    option.world = {plainProgram(world->at("program").get<std::string>()),
                    world->value("arguments", std::vector<std::string>())};
    if (option.value.empty()) throw std::runtime_error("option '" + option.name + "' has a world, but no value");
  }
  option.excluded = json.value("excludes", std::vector<std::string>());
  if (!option.fixed.empty() && (option.element.empty() || !option.value.empty()))
    throw std::runtime_error("option '" + option.name + "' sets an element without naming it or with a value");
  if (!option.name.starts_with("--")) throw std::runtime_error("option '" + option.name + "' does not begin with '--'");
  return option;
}

std::vector<Extension::Option> readOptions(const Descriptor& json) {
  std::vector<Extension::Option> options;
  for (const Descriptor& each : json.value("options", Descriptor::array())) options.push_back(readOption(each));
  return options;
}

Extension::Command readCommand(const Descriptor& json) {
  Extension::Command command;
  command.name = json.at("name").get<std::string>();
  command.help = json.at("help").get<std::string>();
  command.program = plainProgram(json.at("program").get<std::string>());
  for (const Descriptor& each : json.value("actions", Descriptor::array())) {
    command.actions.push_back(
        {each.at("name").get<std::string>(), each.at("help").get<std::string>(), readOptions(each)});
  }
  for (const Descriptor& each : json.value("examples", Descriptor::array()))
    command.examples.push_back(each.get<std::string>());
  return command;
}

Extension extensionOf(const Descriptor& json) {
  if (!json.is_object()) throw std::runtime_error("it is not an object");
  Extension extension;
  if (const auto run = json.find("run"); run != json.end()) {
    extension.system = readSystem(run->at("system"));
    extension.runOptions = readOptions(*run);
  }
  if (const auto command = json.find("command"); command != json.end()) extension.command = readCommand(*command);
  return extension;
}

SourcePosition commandLine() { return {std::make_shared<const std::string>("command line"), 0, 0}; }

/// @return The system's `<plugin>` among those that the user requests.
Element& pluginOf(const Extension::System& system, std::vector<Element>& systems) {
  const auto found = std::ranges::find_if(systems, [&](const Element& each) {
    return each.attributeOr("filename", "") == system.file && each.attributeOr("name", "") == system.className;
  });
  if (found != systems.end()) return *found;
  Element& plugin = systems.emplace_back();
  plugin.name = "plugin";
  plugin.position = commandLine();
  plugin.attributes = {{"filename", system.file, commandLine()}, {"name", system.className, commandLine()}};
  return plugin;
}

void addElement(const std::string& name, const std::string& text, Element& plugin) {
  if (name.empty()) return;
  Element element;
  element.name = name;
  element.text = text;
  element.position = commandLine();
  plugin.children.push_back(std::move(element));
}

/// @return A file's absolute path, since the world's own folder is not that of the command line.
/// @throws UsageError if the path is empty.
std::string fileOf(const Extension::Option& option, const std::string& path) {
  if (path.empty()) throw UsageError("option '" + option.name + "' takes the name of a file, not ''");
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error);
  return error ? path : whole.string();
}

/// Applies an option given by the user, with its values, if it takes any.
/// @throws UsageError if a value is not of the option's type.
void take(const Extension& extension, const Extension::Option& option, const std::vector<std::string>& values,
          RunAdditions& additions) {
  Element& plugin = pluginOf(option.system.value_or(extension.system), additions.systems);
  if (option.value.empty() && !option.fixed.empty()) addElement(option.element, option.fixed, plugin);
  for (const std::string& value : values) {
    option.allowed.check(option.name, value);
    const std::string text = option.isFile ? fileOf(option, value) : value;
    addElement(option.element, text, plugin);
    if (!option.world) continue;
    additions.world = option.world;
    additions.world->arguments.push_back(text);
    additions.worldOption = option.name;
  }
  for (const Extension::Setting& setting : option.implied) addElement(setting.element, setting.text, plugin);
}

}  // namespace

Extension readExtension(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("it can't be read");
  try {
    return extensionOf(Descriptor::parse(stream));
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(error.what());
  }
}

std::vector<Extension> installedExtensions() {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(ownFolder() / "extensions", error)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<Extension> extensions;
  for (const std::filesystem::path& file : files) {
    try {
      extensions.push_back(readExtension(file));
    } catch (const std::exception& wrong) {
      say("warning: the extension " + file.string() + " is left out: " + wrong.what());
    }
  }
  return extensions;
}

void addRunOptions(CLI::App& command, const Extension& extension, RunAdditions& additions) {
  // the options keep it alive
  const auto shared = std::make_shared<const Extension>(extension);
  for (const Extension::Option& option : shared->runOptions) {
    if (option.value.empty()) {
      command
          .add_flag_callback(
              option.name, [shared, &option, &additions] { take(*shared, option, {}, additions); }, option.help)
          ->group(kExtensionGroup)
          ->disable_flag_override();
      continue;
    }
    const auto takeValues = [shared, &option, &additions](const std::vector<std::string>& values) {
      const bool isGiven = !option.isValueOptional || !isLeftOut(values);
      take(*shared, option, isGiven ? values : std::vector<std::string>{}, additions);
      return true;
    };
    command.add_option(option.name, takeValues, option.help)
        ->type_name(option.isValueOptional ? "[" + option.value + "]" : option.value)
        ->group(kExtensionGroup)
        ->type_size(1)
        ->expected(option.isValueOptional ? 0 : 1, option.isRepeated ? CLI::detail::expected_max_vector_size : 1)
        ->allow_extra_args(false);
  }
}

void checkExcluded(const CLI::App& command, const Extension& extension) {
  for (const Extension::Option& option : extension.runOptions) {
    if (command.count(option.name) == 0) continue;
    for (const std::string& other : option.excluded) {
      const CLI::Option* const found = command.get_option_no_throw(other);
      if (found == nullptr || found->count() == 0) continue;
      throw UsageError("options '" + option.name + "' and '" + other + "' can't be used together");
    }
  }
}

}  // namespace pongsim::cli
