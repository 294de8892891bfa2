#pragma once

#include <cstdint>
#include <string_view>

#include "pongsim/export.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// A stream of random numbers. It depends only on the run's seed and its own name, so adding a system does not change
/// the numbers of others. Generator: PCG32 (O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically Good
/// Algorithms for Random Number Generation", 2014); the same numbers on every machine.
class PONGSIM_API Random {
 public:
  Random(std::uint64_t seed, std::string_view streamName);

  /// @return An independent stream for a part with that name: numbers drawn from it do not affect other streams.
  Random split(std::string_view name);

  /// @return A stream that depends on this stream's name and position and on `number`: for draws at certain times that
  /// must not depend on the number of earlier draws.
  Random at(std::uint64_t number) const;

  /// @return A number in [0, 1) with 53 random bits.
  double uniform();

  /// @return A normally distributed number (Marsaglia's polar method).
  double normal(double mean, double standardDeviation);

  /// Position in the stream.
  void transfer(StateArchive& archive) {
    archive(state_);
    archive(increment_);
    // an even one may repeat a number for ever
    archive.check(increment_ % 2 == 1);
    archive(spare_);
    archive(hasSpare_);
  }

 private:
  std::uint32_t next();

  std::uint64_t state_ = 0;
  std::uint64_t increment_ = 0;
  double spare_ = 0;
  bool hasSpare_ = false;
};

}  // namespace pongsim
