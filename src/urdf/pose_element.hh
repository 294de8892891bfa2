#pragma once

#include <string>
#include <string_view>

#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim::urdf {

/// Adds a `<pose>`, exact to the last bit.
void addPose(Element& parent, const Pose& pose, const SourcePosition& position, std::string_view relativeTo = {});

/// @return The shortest text that reads as the same number; "0" for -0.
std::string textOf(double value);
std::string textOf(const Vector3& vector);

}  // namespace pongsim::urdf
