#pragma once

#include <string_view>

#include "pongsim/element.hh"
#include "pongsim/sensing/noise_settings.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads the `<noise>` of an element; none if the element is null or has none.
/// @param fallback The type if the file does not give one.
NoiseSettings readNoiseIn(const Element* holder, NoiseSettings::Type fallback, Context& context);

/// Reads the `<noise>` of a child element, such as `<x>` in `<angular_velocity>`. None if the child is missing.
NoiseSettings readNoise(const Element* parent, std::string_view child, Context& context);

/// Reads the noise of `<x>`, `<y>` and `<z>` in an element; null: none.
NoiseSettings3 readNoise3(const Element* parent, Context& context);

}  // namespace pongsim::sdf
