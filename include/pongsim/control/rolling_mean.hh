#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// Mean of the last `kLength` values.
template <std::size_t kLength>
class RollingMean {
 public:
  void add(double value) {
    values_[next_] = value;
    next_ = (next_ + 1) % kLength;
    count_ = std::min(count_ + 1, kLength);
  }

  /// @return The mean; zero without values.
  double mean() const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += values_[i];
    return count_ > 0 ? sum / static_cast<double>(count_) : 0;
  }

  void transfer(StateArchive& archive) {
    for (double& value : values_) archive(value);
    archive(next_);
    archive(count_);
    archive.check(next_ < kLength && count_ <= kLength);
  }

 private:
  std::array<double, kLength> values_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace pongsim
