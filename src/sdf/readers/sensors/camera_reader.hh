#pragma once

#include <string>

#include "pongsim/element.hh"
#include "pongsim/sensing/camera_settings.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads the `<camera>` of a sensor, except for its pose.
/// @param element Null if there is none.
/// @param label "sensor 's'", for errors.
CameraSettings readCamera(const Element* element, const std::string& label, Context& context);

}  // namespace pongsim::sdf
