#pragma once

#include <string_view>

#include "pongsim/element.hh"

namespace pongsim {

/// @param sensor A `<sensor>` element.
/// @return The `gz:type` of a sensor of the type "custom", such as "environmental_sensor/humidity"; empty without one.
inline std::string_view customTypeOf(const Element& sensor) {
  for (const char* const name : {"gz:type", "ignition:type"}) {
    if (const Element::Attribute* type = sensor.attribute(name)) return type->value;
  }
  return {};
}

}  // namespace pongsim
