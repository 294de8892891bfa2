#pragma once

#include <string>

#include "pongsim/element.hh"
#include "pongsim/sensing/sensor_settings.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads the `<lidar>` or `<ray>` of a sensor.
/// @param element Null if there is none.
/// @param label "sensor 's'", for errors.
LidarSettings readLidar(const Element* element, const std::string& label, Context& context);

}  // namespace pongsim::sdf
