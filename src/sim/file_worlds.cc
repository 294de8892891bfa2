#include "sim/file_worlds.hh"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "description/model_sensors.hh"
#include "plugin/sensor_plugins.hh"
#include "pongsim/node.hh"
#include "sim/plugin_elements.hh"

namespace pongsim::sim {

namespace {

/// @return The plugins of a world around these models: those that simulate their sensors, with physics and scene
/// broadcaster; none if there are no such sensors, which means the default systems of Fortress's server.
std::vector<description::Plugin> pluginsFor(const std::vector<description::Model>& models) {
  std::vector<description::Plugin> plugins;
  const auto add = [&](const description::Sensor& sensor) {
    description::Plugin plugin = plugin::sensorPlugin(sensor.type);
    if (!plugin.filename.empty() && std::ranges::find(plugins, plugin) == plugins.end()) {
      plugins.push_back(std::move(plugin));
    }
  };
  for (const description::Model& model : models) description::forEachSensor(model, add);
  if (plugins.empty()) return plugins;
  plugins.insert(plugins.begin(), {plugin::fortressPlugin("physics", "Physics"), defaultSceneBroadcaster()});
  return plugins;
}

/// @return A world with the file's top-level models, lights and actors, a ground, a sun, and the default settings.
description::World worldAround(sdf::Root root) {
  constexpr std::string_view kWorld =
      "<sdf version='1.9'><world name='default'><light name='sun' type='directional'><pose>0 0 10 0 0 0</pose></light>"
      "<model name='ground_plane'><static>true</static><link name='link'>"
      "<collision name='collision'><geometry><plane><size>100 100</size></plane></geometry></collision>"
      "<visual name='visual'><geometry><plane><size>100 100</size></plane></geometry></visual>"
      "</link></model></world></sdf>";
  Diagnostics none;
  description::World world = std::move(sdf::loadText(kWorld, "default world", none, {}).worlds.at(0));
  const auto addTo = [](auto& standard, auto& own) {
    // a model or light of the file replaces the standard one of the same name
    for (const auto& part : own) std::erase_if(standard, [&](const auto& other) { return other.name == part.name; });
    std::ranges::move(own, std::back_inserter(standard));
  };
  world.plugins = pluginsFor(root.models);
  addTo(world.models, root.models);
  addTo(world.lights, root.lights);
  addTo(world.actors, root.actors);
  return world;
}

}  // namespace

bool prepareWorlds(sdf::Root& root, Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : root.unsimulated.all()) diagnostics.add(diagnostic);
  if (diagnostics.hasErrors()) return false;
  if (!root.worlds.empty()) return true;
  description::World around = worldAround(std::move(root));
  root.worlds.clear();
  root.worlds.push_back(std::move(around));
  return true;
}

std::optional<std::size_t> chooseWorld(const std::vector<description::World>& worlds, const std::string& name,
                                       Diagnostics& diagnostics) {
  if (!name.empty()) {
    const auto found = std::ranges::find(worlds, name, &description::World::name);
    if (found != worlds.end()) return static_cast<std::size_t>(found - worlds.begin());
    std::string names;
    for (const description::World& world : worlds) names += (names.empty() ? "'" : ", '") + world.name + "'";
    diagnostics.error(worlds.front().position, "there is no world '" + name + "' in this file", "it has " + names);
    return std::nullopt;
  }
  for (std::size_t i = 1; i < worlds.size(); ++i) {
    diagnostics.warning(worlds[i].position,
                        "world '" + worlds[i].name + "' is left out: the first one is used, '" + worlds[0].name + "'",
                        "name the world to choose another");
  }
  return 0;
}

void checkTopicNames(const std::vector<description::World>& worlds, Diagnostics& diagnostics) {
  for (std::size_t i = 1; i < worlds.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const std::string topics = cleanTopic("/world/" + worlds[i].name);
      if (topics != cleanTopic("/world/" + worlds[j].name)) continue;
      diagnostics.error(worlds[i].position,
                        "the topics of world '" + worlds[i].name + "' collide with those of world '" + worlds[j].name +
                            "': " + topics + "/...",
                        "rename one of them");
    }
  }
}

}  // namespace pongsim::sim
