#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"
#include "sim/inputs/recording.hh"

namespace pongsim::cli {

/// The first step after which two worlds differ.
struct FirstDifference {
  /// Steps made; 0: they differ from the start.
  std::uint64_t steps = 0;
  Time time{0};
  /// What differs, in lines as `sim::differences` has them.
  std::vector<std::string> lines;
  /// Whether the first world has had the recorded bits, as far as bits were recorded.
  bool isFirstAsRecorded = true;
};

/// Runs two worlds side by side with the same inputs, until they differ, the inputs end, or `until` steps are made.
/// @return Nothing if no bit differs.
std::optional<FirstDifference> compare(Simulation& a, Simulation& b, const sim::Tape& inputs, bool paused,
                                       std::optional<std::uint64_t> until);

/// @return "world 'w' differs from step 17 on (0.017 s):" and the lines.
std::string textOf(const FirstDifference& difference, const std::string& world);

}  // namespace pongsim::cli
