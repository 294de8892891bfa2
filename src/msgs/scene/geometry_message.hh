#pragma once

#include "description/geometry.hh"

namespace ignition::msgs {
class Geometry;
}

namespace pongsim::msgs {

/// Fills in a geometry as Fortress does. Files are named by their full path, or as in the description where they are
/// not there.
void setGeometry(const description::Geometry& geometry, ignition::msgs::Geometry& message);

/// @return The geometry that a message tells of. Its files are named as the message does (`uri`) and not looked for,
/// and it has no triangles.
description::Geometry geometryFrom(const ignition::msgs::Geometry& message);

}  // namespace pongsim::msgs
