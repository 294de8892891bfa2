#pragma once

#include <string>

namespace pongsim::benchmark {

/// @return SDF of a model in a field of boxes, spheres and cylinders in rows. Each has the same content as a model in
/// Fortress's shapes.sdf.
std::string shapeModel(int number);

/// @return A file with a world of this many such models.
std::string shapesWorld(int count);

/// @param count A multiple of three: as many boxes, cylinders and spheres.
/// @param falls Whether they start tilted, 1 m above the ground; else they stand on it.
/// @return A world like `3k_shapes.sdf` of gz-sim's examples, which has 3,000 shapes of 1 m side by side in three rows,
/// but without visuals.
std::string worldOfShapes(int count, bool falls);

}  // namespace pongsim::benchmark
