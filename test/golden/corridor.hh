#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pongsim/types.hh"

namespace pongsim::test {

/// A pose of the chassis that another engine gave.
struct Sample {
  Time time{0};
  /// World frame [m].
  Vector3 position;
};

/// Reads a recorded path: columns t, x, y, z, and a rotation that is left out.
std::vector<Sample> readSamples(const std::filesystem::path& file);

/// Fails the test where a run leaves the path: by more than 2 % of the distance so far, or by 5 mm while that is more.
/// @param start Position at the start.
/// @param positionAt Runs on to that time and gives the position there.
void expectWithinCorridor(const std::vector<Sample>& samples, const Vector3& start,
                          const std::function<Vector3(Time)>& positionAt);

}  // namespace pongsim::test
