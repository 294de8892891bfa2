#pragma once

#include <string>

#include "pongsim/sensing/sensor_settings.hh"

namespace pongsim::cli {

/// @param indent Number of spaces before each line.
/// @return The settings as printed by `ign model -s`; empty for types that it prints nothing about.
std::string sensorText(const SensorSettings& settings, int indent);

}  // namespace pongsim::cli
