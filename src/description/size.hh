#pragma once

#include <span>
#include <vector>

#include "description/geometry.hh"

namespace pongsim::description {

/// @return The size of a simple shape [m], as in its element: x, y and z of a box, the radius of a sphere, radius and
/// length of a cylinder or capsule, the radii of an ellipsoid; empty for other shapes.
std::vector<double> sizeOf(const Geometry& geometry);

/// Gives a simple shape another size.
/// @param size As many numbers as `sizeOf` has.
void setSize(Geometry& geometry, std::span<const double> size);

}  // namespace pongsim::description
