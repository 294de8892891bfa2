#pragma once

#include <string>

#include "pongsim/sensing/sensor_settings.hh"

namespace pongsim::cli {

/// @param indent Blanks before each line.
/// @return The settings as `ign model -s` prints them; empty for types of which it prints none.
std::string sensorText(const SensorSettings& settings, int indent);

}  // namespace pongsim::cli
