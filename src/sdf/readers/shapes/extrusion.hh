#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "description/triangle_mesh.hh"

namespace pongsim::sdf {

/// Closed lines in the xy plane; the first point is not repeated at the end.
using Outline = std::vector<std::vector<Eigen::Vector2d>>;

/// Maximum number of points of an outline: the time to fill it grows faster than their number.
inline constexpr std::size_t kMostOutlinePoints = 5'000;

/// @return Whether a line meets itself or another one anywhere but at the points that join its own edges.
bool crosses(const Outline& outline);

/// Extrudes the area enclosed by an odd number of lines from z = 0 to `height` [m], which must be positive. Triangles
/// are counter-clockwise seen from outside, and share the vertices of their edges.
/// @param outline At least three points for each line; must not cross.
std::shared_ptr<const description::TriangleMesh> extrude(const Outline& outline, double height);

}  // namespace pongsim::sdf
