#include "wind_settings.hh"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>

#include "pongsim/parameters.hh"

namespace pongsim {

namespace {

// Fortress's lower limit of rise times [s].
constexpr double kShortestRise = 1e-6;

void warnOfUnknown(const Element& element, std::initializer_list<std::string_view> known, Diagnostics& diagnostics) {
  for (const Element& child : element.children) {
    if (std::ranges::find(known, child.name) != known.end()) continue;
    std::string names;
    for (const std::string_view name : known) names += (names.empty() ? "<" : ", <") + std::string(name) + ">";
    diagnostics.warning(child.position, "<" + child.name + "> is unknown in <" + element.name + ">",
                        "it can contain " + names);
  }
}

double numberIn(const Element& element, std::string_view name, double fallback) {
  const double value = element.get(name, fallback);
  if (!std::isfinite(value)) refuse(*element.child(name), "<" + std::string(name) + "> must be a finite number");
  return value;
}

void readRise(const Element& element, WindPartSettings& part) {
  part.riseTime = numberIn(element, "time_for_rise", part.riseTime);
  if (part.riseTime >= kShortestRise) return;
  refuse(*element.child("time_for_rise"), "<time_for_rise> must be at least 1e-06");
}

/// @param amplitude Name of the element with the wave's amplitude.
WindPartSettings readPart(const Element* element, std::string_view amplitude, Diagnostics& diagnostics) {
  WindPartSettings part;
  if (element == nullptr) return part;
  warnOfUnknown(*element, {"time_for_rise", "sin", "noise"}, diagnostics);
  readRise(*element, part);
  part.noise = noiseIn(*element);
  const Element* wave = element->child("sin");
  if (wave == nullptr) return part;
  warnOfUnknown(*wave, {amplitude, "period"}, diagnostics);
  part.waveAmplitude = numberIn(*wave, amplitude, part.waveAmplitude);
  part.wavePeriod = numberIn(*wave, "period", part.wavePeriod);
  if (part.wavePeriod <= 0) refuse(*wave->child("period"), "<period> must be above zero");
  return part;
}

}  // namespace

WindSettings readWindSettings(const Element& plugin, Diagnostics& diagnostics) {
  WindSettings settings;
  if (const Element* horizontal = plugin.child("horizontal")) {
    warnOfUnknown(*horizontal, {"magnitude", "direction"}, diagnostics);
    settings.magnitude = readPart(horizontal->child("magnitude"), "amplitude_percent", diagnostics);
    settings.direction = readPart(horizontal->child("direction"), "amplitude", diagnostics);
  }
  if (const Element* vertical = plugin.child("vertical")) {
    warnOfUnknown(*vertical, {"time_for_rise", "noise"}, diagnostics);
    readRise(*vertical, settings.vertical);
    settings.vertical.noise = noiseIn(*vertical);
  }
  return settings;
}

}  // namespace pongsim
