#pragma once

#include <array>

namespace pongsim {

/// How a value is falsified, as `<noise>` says. All but the times in the unit of the value.
struct NoiseSettings {
  enum class Type { kNone, kGaussian, kGaussianQuantized };
  Type type = Type::kNone;
  double mean = 0;
  double standardDeviation = 0;
  /// Of an offset that is drawn once, its sign too.
  double biasMean = 0;
  double biasStandardDeviation = 0;
  /// Of an offset that wanders, and the time in which it does [s]; it stands still where one of them is zero.
  double dynamicBiasStandardDeviation = 0;
  double dynamicBiasCorrelationTime = 0;
  /// With `kGaussianQuantized` the result is a multiple of it; zero: it is not rounded.
  double precision = 0;
  bool operator==(const NoiseSettings&) const = default;
};

/// Noise along x, y and z.
using NoiseSettings3 = std::array<NoiseSettings, 3>;

}  // namespace pongsim
