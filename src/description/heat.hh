#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace pongsim::description {

/// Temperature of a visual for thermal cameras, from the system `thermal` in it.
struct Heat {
  /// The same everywhere, without a signature [K].
  double temperature = 0;
  /// Image of which the red channel, 0 to 1, stands for temperatures from `coldest` to `hottest`; empty: none.
  std::filesystem::path signature = {};
  /// [K]; unset: that of the world's atmosphere.
  std::optional<double> coldest = {};
  std::optional<double> hottest = {};
  bool operator==(const Heat&) const = default;
};

}  // namespace pongsim::description
