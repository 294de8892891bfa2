#include "sim/running/server_config.hh"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "pongsim/program/gazebo_variable.hh"
#include "sdf/text/document.hh"
#include "sdf/text/file_text.hh"

namespace pongsim::sim {

namespace {

/// The first variable that is set is used, even if it is empty.
constexpr const char* kVariables[] = {gazebo::kServerConfigPath.fortress, gazebo::kServerConfigPath.later};

/// Attributes of a `<plugin>` in a server config file that one in a world does not have: the entity that gets the
/// system.
constexpr std::string_view kEntityName = "entity_name", kEntityType = "entity_type";

/// @return The model with that name, plain or scoped ("outer::inner"), or null.
description::Model* findModel(std::vector<description::Model>& models, std::string_view name) {
  for (description::Model& model : models) {
    if (model.name == name) return &model;
    const bool isBelow = name.starts_with(model.name + "::");
    if (description::Model* inner = findModel(model.models, isBelow ? name.substr(model.name.size() + 2) : name)) {
      return inner;
    }
  }
  return nullptr;
}

description::Plugin pluginOf(const Element& element) {
  description::Plugin plugin{element.attributeOr("filename", ""), element.attributeOr("name", ""), element};
  std::erase_if(plugin.sdf.attributes,
                [](const auto& attribute) { return attribute.name == kEntityName || attribute.name == kEntityType; });
  return plugin;
}

bool isComplete(const Element& plugin, Diagnostics& diagnostics) {
  for (const std::string_view name :
       {std::string_view("filename"), std::string_view("name"), kEntityName, kEntityType}) {
    if (!plugin.attributeOr(name, "").empty()) continue;
    diagnostics.warning(plugin.position,
                        "<plugin> of the server config file has no " + std::string(name) + "; left out",
                        "<plugin entity_name=\"*\" entity_type=\"world\" filename=\"...\" name=\"...\"/>");
    return false;
  }
  return true;
}

void give(const Element& plugin, description::World& world, Diagnostics& diagnostics) {
  if (!isComplete(plugin, diagnostics)) return;
  const std::string name = plugin.attributeOr(kEntityName, ""), type = plugin.attributeOr(kEntityType, "");
  if (type == "world") {
    if (name == "*" || name == world.name) world.plugins.push_back(pluginOf(plugin));
    return;
  }
  if (type != "model") {
    diagnostics.warning(plugin.position,
                        "a system for the " + type + " '" + name + "' is left out: systems belong to worlds and models",
                        "entity_type=\"world\" or \"model\"");
    return;
  }
  if (description::Model* model = findModel(world.models, name)) {
    model->plugins.push_back(pluginOf(plugin));
  } else {
    diagnostics.warning(plugin.position,
                        "world '" + world.name + "' has no model '" + name + "': its system is left out");
  }
}

/// Warns that the world has no systems, and why.
void warnOfNone(const SourcePosition& position, const std::string& why, Diagnostics& diagnostics) {
  diagnostics.warning(position, why + ": no system is loaded", "unset the variable for the default systems");
}

}  // namespace

bool applyServerConfig(description::World& world, Diagnostics& diagnostics) {
  const auto variable = std::ranges::find_if(kVariables, [](const char* name) { return std::getenv(name) != nullptr; });
  const auto isSystem = [](const description::Plugin& plugin) { return !description::isLevelPlan(plugin.className); };
  if (variable == std::end(kVariables) || std::ranges::any_of(world.plugins, isSystem)) return false;
  const std::filesystem::path file = std::getenv(*variable);
  const SourcePosition environment{std::make_shared<const std::string>(*variable), 0, 0};
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    warnOfNone(environment, "there is no file '" + file.string() + "'", diagnostics);
    return true;
  }
  const auto name = std::make_shared<const std::string>(file.string());
  const std::optional<std::string> text = sdf::readFileText(file, name, sdf::NamedBy::kUser, diagnostics);
  const std::optional<Element> root = text ? sdf::parseDocument(*text, name, diagnostics) : std::nullopt;
  if (!root) return true;
  const Element* plugins = root->child("plugins");
  if (plugins == nullptr || plugins->childrenNamed("plugin").empty()) {
    warnOfNone(root->position, "the server config file has no <plugin> in a <plugins>", diagnostics);
    return true;
  }
  for (const Element* plugin : plugins->childrenNamed("plugin")) give(*plugin, world, diagnostics);
  return true;
}

}  // namespace pongsim::sim
