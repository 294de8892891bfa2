#pragma once

#include <vector>

namespace pongsim::cli {

/// Distribution of values.
struct Spread {
  double mean = 0, least = 0, most = 0;
  /// The standard deviation.
  double deviation = 0;
};

/// @param values At least one.
Spread spreadOf(const std::vector<double>& values);

}  // namespace pongsim::cli
