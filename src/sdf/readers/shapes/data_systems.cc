#include "sdf/readers/shapes/data_systems.hh"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <string_view>
#include <utility>

#include "base/parse_number.hh"
#include "sdf/includes/asset_file.hh"
#include "sdf/schema/value_check.hh"

namespace pongsim::sdf {

namespace {

constexpr int kLargestLabel = 255;

/// @param name "label"
/// @param className "Label"
/// @return The last such system, which counts in Fortress; null if there is none.
const description::Plugin* find(const std::vector<description::Plugin>& plugins, std::string_view name,
                                std::string_view className) {
  const std::string ending = "systems::" + std::string(className), file = "-" + std::string(name) + "-system";
  for (const description::Plugin& plugin : plugins | std::views::reverse) {
    const bool isIt =
        plugin.className.empty() ? plugin.filename.find(file) != std::string::npos : plugin.className.ends_with(ending);
    if (isIt) return &plugin;
  }
  return nullptr;
}

/// Reads the elements of a `<plugin>`.
class PluginReader {
 public:
  /// @param system Its name in messages: "label".
  PluginReader(const description::Plugin& plugin, std::string system, const std::string& owner, Context& context)
      : sdf_(plugin.sdf), who_(std::move(system) + " of " + owner), context_(context) {}

  bool has(std::string_view child) const { return sdf_.child(child) != nullptr; }

  /// @return Nothing if it is missing, or with a warning, if it is no finite number.
  std::optional<double> number(std::string_view child) const {
    const Element* element = sdf_.child(child);
    if (element == nullptr) return std::nullopt;
    std::optional<double> value = base::parseDouble(element->text);
    if (value && std::isfinite(*value)) return value;
    warnOf(child, "is '" + quoted(element->text) + "', which is not a finite number", "it has no effect");
    return std::nullopt;
  }

  /// Warns "label of visual 'v': <label> WHAT", where the element is.
  void warnOf(std::string_view child, const std::string& what, const std::string& hint) const {
    const Element* element = sdf_.child(child);
    context_.diagnostics.warning(element != nullptr ? element->position : sdf_.position,
                                 who_ + ": <" + std::string(child) + "> " + what, hint);
  }

  void warn(const std::string& what, const std::string& hint = {}) const {
    context_.diagnostics.warning(sdf_.position, who_ + " " + what, hint);
  }

  const Element& sdf() const { return sdf_; }

 private:
  const Element& sdf_;
  std::string who_;
  Context& context_;
};

description::Heat readSignature(const PluginReader& reader, Context& context) {
  description::Heat heat;
  if (reader.has("temperature")) {
    reader.warnOf("temperature", "has no effect beside a <heat_signature>",
                  "as in Fortress, there is only one of them");
  }
  heat.signature = readTexture(reader.sdf(), "heat_signature", context).file;
  heat.coldest = reader.number("min_temp");
  heat.hottest = reader.number("max_temp");
  if (heat.coldest && heat.hottest && *heat.coldest > *heat.hottest) {
    reader.warnOf("min_temp", "is above <max_temp>", "they are swapped, as in Fortress");
    std::swap(heat.coldest, heat.hottest);
  }
  return heat;
}

}  // namespace

std::optional<std::uint8_t> readLabel(const std::vector<description::Plugin>& plugins, const std::string& owner,
                                      Context& context) {
  const description::Plugin* plugin = find(plugins, "label", "Label");
  if (plugin == nullptr) return std::nullopt;
  const PluginReader reader(*plugin, "label", owner, context);
  if (!reader.has("label")) {
    reader.warn("is left out: it has no <label>", "write <label>NUMBER</label>");
    return std::nullopt;
  }
  const std::optional<double> label = reader.number("label");
  if (!label) return std::nullopt;
  if (*label >= 0 && *label <= kLargestLabel && std::trunc(*label) == *label) return static_cast<std::uint8_t>(*label);
  reader.warnOf("label", "is '" + quoted(plugin->sdf.child("label")->text) + "', which is not an integer from 0 to 255",
                "it has no effect");
  return std::nullopt;
}

std::optional<description::Heat> readHeat(const std::vector<description::Plugin>& plugins, const std::string& owner,
                                          Context& context) {
  const description::Plugin* plugin = find(plugins, "thermal", "Thermal");
  if (plugin == nullptr) return std::nullopt;
  const PluginReader reader(*plugin, "thermal", owner, context);
  if (reader.has("heat_signature")) {
    description::Heat heat = readSignature(reader, context);
    if (!heat.signature.empty()) return heat;
    reader.warn("is left out: its <heat_signature> can't be found");
    return std::nullopt;
  }
  if (!reader.has("temperature")) {
    reader.warn("is left out: it has neither <temperature> nor <heat_signature>");
    return std::nullopt;
  }
  const std::optional<double> temperature = reader.number("temperature");
  if (!temperature) return std::nullopt;
  if (*temperature < 0) reader.warnOf("temperature", "is below absolute zero", "0 K is used");
  return description::Heat{.temperature = std::max(*temperature, 0.0)};
}

ThermalSettings readThermal(const std::vector<description::Plugin>& plugins, const std::string& owner,
                            Context& context) {
  ThermalSettings settings;
  const description::Plugin* plugin = find(plugins, "thermal-sensor", "ThermalSensor");
  if (plugin == nullptr) return settings;
  const PluginReader reader(*plugin, "thermal-sensor", owner, context);
  const std::optional<double> resolution = reader.number("resolution");
  if (resolution && *resolution > 0) {
    settings.resolution = resolution;
  } else if (resolution) {
    reader.warnOf("resolution", "is not above zero", "the default is used");
  }
  const double coldest = reader.number("min_temp").value_or(settings.coldest);
  const double hottest = reader.number("max_temp").value_or(settings.hottest);
  if (coldest > hottest) {
    reader.warnOf("min_temp", "is above <max_temp>", "all temperatures are shown");
    return settings;
  }
  settings.coldest = std::max(coldest, 0.0);
  settings.hottest = std::max(hottest, 0.0);
  return settings;
}

}  // namespace pongsim::sdf
