#pragma once

#include <benchmark/benchmark.h>

#include "description/geometry.hh"

namespace pongsim::benchmark {

/// Measures steps of ten bowls of 4,800 triangles at rest on a plane, with or without a ball in each.
void stepBowls(::benchmark::State& run, description::MeshOptimization optimization, bool haveBalls);

/// Measures the time before the first step of ten different meshes of 5,000 triangles each: five bowls and five rings.
/// @param isWarm Whether their convex pieces are in the cache.
void startMeshes(::benchmark::State& run, bool isWarm);

}  // namespace pongsim::benchmark
