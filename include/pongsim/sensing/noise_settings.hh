#pragma once

#include <array>

namespace pongsim {

/// Noise on a value, as in `<noise>`. All but times are in the unit of the value.
struct NoiseSettings {
  enum class Type { kNone, kGaussian, kGaussianQuantized };
  Type type = Type::kNone;
  double mean = 0;
  double standardDeviation = 0;
  /// A constant offset, drawn once including its sign.
  double biasMean = 0;
  double biasStandardDeviation = 0;
  /// A drifting offset, and its correlation time [s]; constant if one of them is zero.
  double dynamicBiasStandardDeviation = 0;
  double dynamicBiasCorrelationTime = 0;
  /// For `kGaussianQuantized`: results are multiples of it; zero: not rounded.
  double precision = 0;
  bool operator==(const NoiseSettings&) const = default;
};

/// Noise along x, y and z.
using NoiseSettings3 = std::array<NoiseSettings, 3>;

}  // namespace pongsim
