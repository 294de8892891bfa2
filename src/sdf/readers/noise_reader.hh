#pragma once

#include <string_view>

#include "pongsim/element.hh"
#include "pongsim/sensing/noise_settings.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads the `<noise>` of an element; null, or without one: none.
/// @param fallback Its type where the file gives none.
NoiseSettings readNoiseIn(const Element* holder, NoiseSettings::Type fallback, Context& context);

/// Reads the `<noise>` of an element's child of that name: of `<x>` in `<angular_velocity>`. None where it is missing.
NoiseSettings readNoise(const Element* parent, std::string_view child, Context& context);

/// Reads the noise of `<x>`, `<y>` and `<z>` in an element; null: none.
NoiseSettings3 readNoise3(const Element* parent, Context& context);

}  // namespace pongsim::sdf
