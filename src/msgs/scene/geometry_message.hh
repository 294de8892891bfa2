#pragma once

#include "description/geometry.hh"

namespace ignition::msgs {
class Geometry;
}

namespace pongsim::msgs {

/// Fills in a geometry as Fortress does. Files are given by full path, or as in the description if they do not exist.
void setGeometry(const description::Geometry& geometry, ignition::msgs::Geometry& message);

/// @return The geometry in a message. Its files keep the message's names (`uri`) and are not looked for, and it has no
/// triangles.
description::Geometry geometryFrom(const ignition::msgs::Geometry& message);

}  // namespace pongsim::msgs
