#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pongsim/types.hh"

namespace pongsim::test {

/// A recorded position of the chassis in another engine.
struct Sample {
  Time time{0};
  /// World frame [m].
  Vector3 position;
};

/// Reads a recorded path: columns t, x, y, z, and a rotation, which is ignored.
std::vector<Sample> readSamples(const std::filesystem::path& file);

/// Fails the test where a run is further from the path than 2 % of the distance so far, or 5 mm if that is more.
/// @param start Position at the start.
/// @param positionAt Continues the run to this time, and returns the position.
void expectWithinCorridor(const std::vector<Sample>& samples, const Vector3& start,
                          const std::function<Vector3(Time)>& positionAt);

}  // namespace pongsim::test
