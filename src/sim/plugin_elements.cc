#include "sim/plugin_elements.hh"

#include <algorithm>
#include <string_view>

#include "plugin/sensor_plugins.hh"
#include "plugin/system_name.hh"

namespace pongsim::sim {

namespace {

/// @return A class name without namespaces, because libraries register a system under several namespaces.
std::string_view plainName(std::string_view className) {
  const std::size_t colon = className.rfind(':');
  return colon == std::string_view::npos ? className : className.substr(colon + 1);
}

}  // namespace

description::Plugin defaultSceneBroadcaster() {
  return plugin::fortressPlugin("scene-broadcaster", "SceneBroadcaster");
}

std::vector<description::Plugin> pluginsOf(const std::vector<Element>& elements) {
  std::vector<description::Plugin> plugins;
  for (const Element& each : elements)
    plugins.push_back({each.attributeOr("filename", ""), each.attributeOr("name", ""), each});
  return plugins;
}

description::Plugin joined(description::Plugin plugin, std::vector<description::Plugin>& more) {
  const auto same = std::ranges::find_if(more, [&](const description::Plugin& each) {
    return plugin::systemName(each.filename) == plugin::systemName(plugin.filename) &&
           plainName(each.className) == plainName(plugin.className);
  });
  if (same == more.end()) return plugin;
  // of several child elements of one name the first is used, so those of `more` take precedence
  std::vector<Element>& children = plugin.sdf.children;
  children.insert(children.begin(), same->sdf.children.begin(), same->sdf.children.end());
  for (const Element::Attribute& attribute : same->sdf.attributes) {
    if (plugin.sdf.attribute(attribute.name) == nullptr) plugin.sdf.attributes.push_back(attribute);
  }
  more.erase(same);
  return plugin;
}

}  // namespace pongsim::sim
