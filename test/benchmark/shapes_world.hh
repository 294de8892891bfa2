#pragma once

#include <string>

namespace pongsim::benchmark {

/// @return The model of that number of a field of boxes, spheres and cylinders in rows, each with what a model of
/// Fortress's shapes.sdf has, as text of SDF.
std::string shapeModel(int number);

/// @return A file with a world of that many of them.
std::string shapesWorld(int count);

}  // namespace pongsim::benchmark
