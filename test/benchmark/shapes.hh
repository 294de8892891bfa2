#pragma once

#include <string>

namespace pongsim::benchmark {

/// @param count A multiple of three: as many boxes, cylinders and spheres.
/// @param falls They begin 1 m above the ground, tilted, else they stand on it.
/// @return A world as `3k_shapes.sdf` of gz-sim's examples has it, which has 3,000: shapes of 1 m beside each other.
std::string worldOfShapes(int count, bool falls);

}  // namespace pongsim::benchmark
