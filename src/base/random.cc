#include "pongsim/random.hh"

#include <cmath>

#include "base/hash.hh"
#include "pongsim/math.hh"

namespace pongsim {

Random::Random(std::uint64_t seed, std::string_view streamName) {
  // PCG's streams differ in their increment, which must be odd.
  base::Hash hash;
  hash.add(streamName);
  increment_ = (hash.value() << 1U) | 1U;
  next();
  state_ += seed;
  next();
}

Random Random::split(std::string_view name) {
  const std::uint64_t high = next();
  return Random((high << 32U) | next(), name);
}

Random Random::at(std::uint64_t number) const {
  // the finalizer of SplitMix64: Steele, Lea, Flood, Fast splittable pseudorandom number generators, OOPSLA 2014
  number = (number ^ (number >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  number = (number ^ (number >> 27U)) * 0x94d049bb133111ebULL;
  Random part = *this;
  part.hasSpare_ = false;
  part.state_ ^= number ^ (number >> 31U);
  part.next();
  return part;
}

std::uint32_t Random::next() {
  const std::uint64_t old = state_;
  state_ = old * 6364136223846793005ULL + increment_;
  const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
  const auto rotation = static_cast<std::uint32_t>(old >> 59U);
  return (shifted >> rotation) | (shifted << ((32U - rotation) & 31U));
}

double Random::uniform() {
  const std::uint64_t high = next() >> 5U;
  const std::uint64_t low = next() >> 6U;
  return static_cast<double>((high << 26U) | low) * 0x1p-53;
}

double Random::normal(double mean, double standardDeviation) {
  if (hasSpare_) {
    hasSpare_ = false;
    return mean + standardDeviation * spare_;
  }
  double x = 0, y = 0, square = 0;
  do {
    x = 2 * uniform() - 1;
    y = 2 * uniform() - 1;
    square = x * x + y * y;
  } while (square >= 1 || square == 0);
  const double factor = std::sqrt(-2 * math::log(square) / square);
  spare_ = y * factor;
  hasSpare_ = true;
  return mean + standardDeviation * x * factor;
}

}  // namespace pongsim
