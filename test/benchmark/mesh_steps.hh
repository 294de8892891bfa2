#pragma once

#include <benchmark/benchmark.h>

#include "description/geometry.hh"

namespace pongsim::benchmark {

/// Steps of ten bowls of 4,800 triangles on a plane, perhaps with a ball in each, all at rest.
void stepBowls(::benchmark::State& run, description::MeshOptimization optimization, bool haveBalls);

/// What comes before the first step of ten meshes of 5,000 triangles each, one of which is not like another: five bowls
/// and five rings.
/// @param isWarm Whether their pieces have been kept.
void startMeshes(::benchmark::State& run, bool isWarm);

}  // namespace pongsim::benchmark
