#pragma once

#include <array>
#include <chrono>
#include <cstddef>

#include "pongsim/types.hh"

namespace pongsim::sim {

/// Measures simulated seconds per second of wall time over about the last second.
class RealTimeFactor {
 public:
  using WallTime = std::chrono::steady_clock::time_point;

  /// Adds a sample. May be called at any rate: samples that follow each other too closely are ignored.
  void sample(WallTime wall, Time simulated);

  /// Discards all samples. To be called after a pause.
  void restart() { count_ = 0; }

  /// @return The factor, or 0 before there are two samples.
  double value() const;

 private:
  struct Sample {
    WallTime wall;
    Time simulated{0};
  };
  static constexpr std::chrono::milliseconds kSpacing{50};
  static constexpr std::size_t kCapacity = 20;

  const Sample& newest() const { return samples_[(next_ + kCapacity - 1) % kCapacity]; }
  const Sample& oldest() const { return samples_[(next_ + kCapacity - count_) % kCapacity]; }

  std::array<Sample, kCapacity> samples_;
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace pongsim::sim
