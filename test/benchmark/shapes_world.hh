#pragma once

#include <string>

namespace pongsim::benchmark {

/// @return The model of that number of a field of boxes, spheres and cylinders in rows, each with what a model of
/// Fortress's shapes.sdf has, as text of SDF.
std::string shapeModel(int number);

/// @return A file with a world of that many of them.
std::string shapesWorld(int count);

/// @param count A multiple of three: as many boxes, cylinders and spheres.
/// @param falls They begin 1 m above the ground, tilted, else they stand on it.
/// @return A world as `3k_shapes.sdf` of gz-sim's examples has it, which has 3,000: shapes of 1 m beside each other, in
/// three rows, with physics and ground, but nothing to be seen.
std::string worldOfShapes(int count, bool falls);

}  // namespace pongsim::benchmark
