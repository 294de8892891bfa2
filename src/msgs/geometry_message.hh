#pragma once

#include "description/geometry.hh"

namespace ignition::msgs {
class Geometry;
}

namespace pongsim::msgs {

/// Fills in a geometry as Fortress does. Files are named by their full path, or as in the description where they are
/// not there.
void setGeometry(const description::Geometry& geometry, ignition::msgs::Geometry& message);

}  // namespace pongsim::msgs
