#pragma once

#include <optional>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::urdf {

/// Converts a URDF robot to an SDF model as Fortress does: links attached by fixed joints become part of their parents,
/// and `<gazebo>` elements are applied.
/// @param robot The `<robot>` element.
/// @return An `<sdf>` element of version 1.7 with one `<model>`, whose parts have the positions of their URDF sources;
/// nothing, with errors, if the robot is invalid.
std::optional<Element> toSdf(const Element& robot, Diagnostics& diagnostics);

}  // namespace pongsim::urdf
