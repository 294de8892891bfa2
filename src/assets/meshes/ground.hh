#pragma once

#include <filesystem>
#include <variant>

#include "assets/problem.hh"
#include "description/triangle_mesh.hh"
#include "pongsim/types.hh"

namespace pongsim::assets {

/// Reads the image of a heightmap, a PNG file.
/// @param size Size of the terrain; z is from black to the brightest pixel [m].
/// @param position Position of its centre, at the height of black [m].
std::variant<description::TriangleMesh, Problem> readGround(const std::filesystem::path& file, const Vector3& size,
                                                            const Vector3& position);

}  // namespace pongsim::assets
