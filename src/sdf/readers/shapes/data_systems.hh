#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "description/heat.hh"
#include "description/plugin.hh"
#include "pongsim/sensing/camera_settings.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

// Systems of Fortress that do nothing in a step, but give data to what they are in. What is wrong in one of them is a
// warning, and it is left out, like other systems.

/// The system `label`, in a visual, a model or an actor.
/// @param owner "visual 'v' of link 'l'"
/// @return Nothing if it is not among the plugins.
std::optional<std::uint8_t> readLabel(const std::vector<description::Plugin>& plugins, const std::string& owner,
                                      Context& context);

/// The system `thermal`, in a visual.
std::optional<description::Heat> readHeat(const std::vector<description::Plugin>& plugins, const std::string& owner,
                                          Context& context);

/// The system `thermal-sensor`, in a camera. What is wrong in it keeps its default.
ThermalSettings readThermal(const std::vector<description::Plugin>& plugins, const std::string& owner,
                            Context& context);

}  // namespace pongsim::sdf
