#include "cli/extension.hh"

#include <CLI/App.hpp>
#include <algorithm>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "cli/console.hh"
#include "cli/own_folder.hh"

namespace pongsim::cli {

namespace {

using Descriptor = nlohmann::json;

Extension::Option readOption(const Descriptor& json) {
  Extension::Option option;
  option.name = json.at("option").get<std::string>();
  option.help = json.at("help").get<std::string>();
  option.value = json.value("value", "");
  option.element = json.value("element", "");
  option.fixed = json.value("sets", "");
  option.isRepeated = json.value("repeated", false);
  option.isFile = json.value("file", false);
  if (!option.fixed.empty() && (option.element.empty() || !option.value.empty()))
    throw std::runtime_error("option '" + option.name + "' sets something, but no element or one with a value");
  if (!option.name.starts_with("--")) throw std::runtime_error("option '" + option.name + "' begins with no '--'");
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
  command.program = json.at("program").get<std::string>();
  if (command.program.find('/') != std::string::npos) throw std::runtime_error("its program is no plain name");
  for (const Descriptor& each : json.value("actions", Descriptor::array())) {
    command.actions.push_back(
        {each.at("name").get<std::string>(), each.at("help").get<std::string>(), readOptions(each)});
  }
  for (const Descriptor& each : json.value("examples", Descriptor::array()))
    command.examples.push_back(each.get<std::string>());
  return command;
}

Extension extensionOf(const Descriptor& json) {
  if (!json.is_object()) throw std::runtime_error("it is no object");
  Extension extension;
  if (const auto run = json.find("run"); run != json.end()) {
    extension.systemFile = run->at("system").at("filename").get<std::string>();
    extension.systemClass = run->at("system").at("name").get<std::string>();
    extension.runOptions = readOptions(*run);
  }
  if (const auto command = json.find("command"); command != json.end()) extension.command = readCommand(*command);
  return extension;
}

SourcePosition commandLine() { return {std::make_shared<const std::string>("command line"), 0, 0}; }

/// @return The extension's `<plugin>` among those that the user asks for.
Element& pluginOf(const Extension& extension, std::vector<Element>& systems) {
  const auto found = std::ranges::find_if(systems, [&](const Element& each) {
    const Element::Attribute* file = each.attribute("filename");
    return file != nullptr && file->value == extension.systemFile;
  });
  if (found != systems.end()) return *found;
  Element& plugin = systems.emplace_back();
  plugin.name = "plugin";
  plugin.position = commandLine();
  plugin.attributes = {{"filename", extension.systemFile, commandLine()},
                       {"name", extension.systemClass, commandLine()}};
  return plugin;
}

void addValue(const Extension& extension, const Extension::Option& option, const std::string& value,
              std::vector<Element>& systems) {
  if (option.element.empty()) return;
  Element element;
  element.name = option.element;
  element.text = option.isFile ? std::filesystem::absolute(value).string() : value;
  element.position = commandLine();
  pluginOf(extension, systems).children.push_back(std::move(element));
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

void addRunOptions(CLI::App& command, const Extension& extension, std::vector<Element>& systems) {
  // the options hold on to it
  const auto shared = std::make_shared<const Extension>(extension);
  for (const Extension::Option& option : shared->runOptions) {
    if (option.value.empty()) {
      command
          .add_flag_callback(
              option.name,
              [shared, &option, &systems] {
                pluginOf(*shared, systems);
                if (!option.fixed.empty()) addValue(*shared, option, option.fixed, systems);
              },
              option.help)
          ->group(kExtensionGroup)
          ->disable_flag_override();
      continue;
    }
    const auto take = [shared, &option, &systems](const std::vector<std::string>& values) {
      pluginOf(*shared, systems);
      for (const std::string& value : values) addValue(*shared, option, value, systems);
      return true;
    };
    command.add_option(option.name, take, option.help)
        ->type_name(option.value)
        ->group(kExtensionGroup)
        ->type_size(1)
        ->expected(1, option.isRepeated ? CLI::detail::expected_max_vector_size : 1)
        ->allow_extra_args(false);
  }
}

}  // namespace pongsim::cli
