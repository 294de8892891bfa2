#pragma once

#include <optional>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::urdf {

/// Makes an SDF model of a URDF robot as Fortress does: links behind fixed joints become part of their parents, and
/// `<gazebo>` elements go where they belong.
/// @param robot The `<robot>` element.
/// @return An `<sdf>` element of version 1.7 with one `<model>`, whose parts have the positions of what they were made
/// from; nothing, and errors added, where the robot is not sound.
std::optional<Element> toSdf(const Element& robot, Diagnostics& diagnostics);

}  // namespace pongsim::urdf
