#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::ros2 {

/// The options of a program built with gflags, like those of ros_gz_sim.
struct SingleDashOptions {
  /// Options that take the next word, whatever it is, or what follows '='.
  std::span<const std::string_view> withValue;
  /// Options without a value; `-noNAME` and `-NAME=false` turn them off.
  std::span<const std::string_view> flags;
};

/// Converts such a command line to two dashes for CLI11: `-world w -x -1.5 -allow_renaming true` becomes `--world=w
/// --x=-1.5 --allow_renaming`. A flag that is turned off is left out, and so is a word true or false after a flag,
/// which gflags ignores and launch files contain. Everything else stays.
/// @param words Without the name of the program.
std::vector<std::string> withTwoDashes(const std::vector<std::string>& words, const SingleDashOptions& options);

}  // namespace pongsim::ros2
