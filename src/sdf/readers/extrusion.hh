#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "description/triangle_mesh.hh"

namespace pongsim::sdf {

/// Closed lines in the xy plane, each without its first point at its end.
using Outline = std::vector<std::vector<Eigen::Vector2d>>;

/// No outline has more points: what it takes to fill one grows faster than their number.
inline constexpr std::size_t kMostOutlinePoints = 5'000;

/// @return Whether a line meets itself or another one anywhere but from one point to the next.
bool crosses(const Outline& outline);

/// Fills what the lines enclose, from z = 0 to `height` [m], which is above zero: what is within an odd number of them.
/// Triangles are wound counter-clockwise seen from outside, and share the vertices of their edges.
/// @param outline At least three points a line; must not cross.
std::shared_ptr<const description::TriangleMesh> extrude(const Outline& outline, double height);

}  // namespace pongsim::sdf
