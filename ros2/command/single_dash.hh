#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::ros2 {

/// The options of a program that was made with gflags, as ros_gz_sim's are.
struct SingleDashOptions {
  /// Those that take the word behind them, whatever it is, or what stands behind '='.
  std::span<const std::string_view> withValue;
  /// Those that take none; `-noNAME` and `-NAME=false` turn them off.
  std::span<const std::string_view> flags;
};

/// Makes of such a command line one with two dashes, as CLI11 wants it: `-world w -x -1.5 -allow_renaming true` becomes
/// `--world=w --x=-1.5 --allow_renaming`. A flag that is turned off is left out, and so is what stands behind a flag
/// and says true or false: gflags takes no notice of it, and launch files have it. All else stays as it is.
/// @param words Without the name of the program.
std::vector<std::string> withTwoDashes(const std::vector<std::string>& words, const SingleDashOptions& options);

}  // namespace pongsim::ros2
