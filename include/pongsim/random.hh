#pragma once

#include <cstdint>
#include <string_view>

#include "pongsim/export.hh"
#include "pongsim/state_archive.hh"

namespace pongsim {

/// A stream of random numbers that depends on the run's seed and on its own name and on nothing else, so that
/// adding a system does not change what another one draws. Generator: PCG32 (O'Neill, "PCG: A Family of Simple
/// Fast Space-Efficient Statistically Good Algorithms for Random Number Generation", 2014); the same numbers on
/// every machine.
class PONGSIM_API Random {
 public:
  Random(std::uint64_t seed, std::string_view streamName);

  /// @return A stream of its own for a part of that name: what the part draws later changes nothing for the others.
  Random split(std::string_view name);

  /// @return The stream from a place on that depends on its name, on how far it has come, and on `number`: for what is
  /// drawn at some moments and must not depend on how much was drawn before.
  Random at(std::uint64_t number) const;

  /// @return A number of [0, 1) with 53 random bits.
  double uniform();

  /// @return A number of the normal distribution, by Marsaglia's polar method.
  double normal(double mean, double standardDeviation);

  /// Where it is in its stream.
  void transfer(StateArchive& archive) {
    archive(state_);
    archive(increment_);
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
