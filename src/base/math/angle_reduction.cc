#include "base/math/angle_reduction.hh"

#include <array>
#include <bit>
#include <cassert>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>

#ifdef __FAST_MATH__
#error "pongsim must not be built with -ffast-math: its results would not be the same everywhere"
#endif
static_assert(FLT_EVAL_METHOD == 0, "arithmetic with more than double precision gives other results");

namespace pongsim::math {

namespace {

__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;

// pi/2 in three parts, all but the last with 33 bits, so that products with numbers of 20 bits are exact. From fdlibm's
// e_rem_pio2.c (Sun Microsystems, 1993)
constexpr double kHalfPi1 = 0x1.921fb544p+0, kHalfPi1Rest = 0x1.0b4611a626331p-34;
constexpr double kHalfPi2 = 0x1.0b4611a6p-34, kHalfPi2Rest = 0x1.3198a2e037073p-69;
constexpr double kHalfPi3 = 0x1.3198a2ep-69, kHalfPi3Rest = 0x1.b839a252049c1p-104;
constexpr double kTwoByPi = 0x1.45f306dc9c883p-1;
constexpr double kHalfPiHigh = 0x1.921fb54442d18p+0, kHalfPiLow = 0x1.1a62633145c07p-54;
// adding it and subtracting it again rounds to an integer
constexpr double kRounder = 0x1.8p52;
constexpr double kLargestMedium = 0x1p20;

int exponentOf(double number) { return static_cast<int>((std::bit_cast<std::uint64_t>(number) >> 52U) & 0x7ffU); }

// Cody and Waite: uses as many parts of pi/2 as needed to make up for cancelled digits
ReducedAngle reduceMedium(double angle) {
  const double count = (angle * kTwoByPi + kRounder) - kRounder;
  double difference = angle - count * kHalfPi1;
  double low = count * kHalfPi1Rest;
  double rest = difference - low;
  const int exponent = exponentOf(angle);
  if (exponent - exponentOf(rest) > 16) {
    double before = difference;
    double part = count * kHalfPi2;
    difference = before - part;
    low = count * kHalfPi2Rest - ((before - difference) - part);
    rest = difference - low;
    if (exponent - exponentOf(rest) > 49) {
      before = difference;
      part = count * kHalfPi3;
      difference = before - part;
      low = count * kHalfPi3Rest - ((before - difference) - part);
      rest = difference - low;
    }
  }
  return {static_cast<unsigned>(static_cast<int>(count)) & 3U, rest, (difference - rest) - low};
}

// The fractional bits of 2/pi, after a word of zeros.
constexpr std::array<std::uint64_t, 21> kBitsOfTwoByPi = {0,
                                                          0xa2f9836e4e441529,
                                                          0xfc2757d1f534ddc0,
                                                          0xdb6295993c439041,
                                                          0xfe5163abdebbc561,
                                                          0xb7246e3a424dd2e0,
                                                          0x06492eea09d1921c,
                                                          0xfe1deb1cb129a73e,
                                                          0xe88235f52ebb4484,
                                                          0xe99c7026b45f7e41,
                                                          0x3991d639835339f4,
                                                          0x9c845f8bbdf9283b,
                                                          0x1ff897ffde05980f,
                                                          0xef2f118b5a0a6d1f,
                                                          0x6d367ecf27cb09b7,
                                                          0x4f463f669e5fea2d,
                                                          0x7527bac7ebe5f17b,
                                                          0x3d0739f78a5292ea,
                                                          0x6bfb5fb11f8d5d08,
                                                          0x56033046fc7b6bab,
                                                          0xf0cfbc209af4361d};

/// @return The 64 bits starting at bit `first`.
std::uint64_t bitsFrom(std::size_t first) {
  const std::size_t word = first / 64, shift = first % 64;
  assert(word + 1 < kBitsOfTwoByPi.size());
  if (shift == 0) return kBitsOfTwoByPi[word];
  return (kBitsOfTwoByPi[word] << shift) | (kBitsOfTwoByPi[word + 1] >> (64 - shift));
}

/// @return `number` as the sum of two numbers of at most 26 bits, so that their products are exact (Veltkamp).
std::array<double, 2> halves(double number) {
  const double scaled = number * 0x1.0000002p27;
  const double high = scaled - (scaled - number);
  return {high, number - high};
}

// Payne and Hanek, Radian reduction for trigonometric functions, SIGNUM 18 (1983): multiplies only those bits of 2/pi
// whose product is neither a whole number of turns nor too small to matter
ReducedAngle reduceLarge(double angle) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(angle);
  const std::uint64_t mantissa = (bits & 0xfffffffffffffU) | 0x10000000000000U;
  // the angle is mantissa * 2^(exponent - 1075); bits of 2/pi whose product has a weight above 2 are left out
  const auto first = static_cast<std::size_t>(exponentOf(angle) - 1075 - 2 + 64);
  const Wide low = static_cast<Wide>(mantissa) * bitsFrom(first + 128);
  const Wide middle = static_cast<Wide>(mantissa) * bitsFrom(first + 64) + (low >> 64U);
  const std::uint64_t high = mantissa * bitsFrom(first) + static_cast<std::uint64_t>(middle >> 64U);
  // two bits of quarter turns, followed by the fraction
  const Wide product = (static_cast<Wide>(high) << 64U) | static_cast<std::uint64_t>(middle);
  auto quarters = static_cast<unsigned>(high >> 62U);
  const auto fraction = static_cast<SignedWide>((product << 2U) | static_cast<std::uint64_t>((low >> 62U) & 3U));
  if (fraction < 0) ++quarters;
  const auto whole = static_cast<double>(fraction);
  const auto left = static_cast<double>(fraction - static_cast<SignedWide>(whole));
  // times pi/2 in double-double precision
  const double part = whole * 0x1p-128;
  const double rest = part * kHalfPiHigh;
  const auto [a, b] = halves(part);
  const auto [c, d] = halves(kHalfPiHigh);
  const double error = ((a * c - rest) + a * d + b * c) + b * d;
  const double tail = error + (part * kHalfPiLow + left * 0x1p-128 * kHalfPiHigh);
  const double sum = rest + tail;
  const double remaining = (rest - sum) + tail;
  if (angle < 0) return {(0U - quarters) & 3U, -sum, -remaining};
  return {quarters & 3U, sum, remaining};
}

}  // namespace

ReducedAngle reduceAngle(double angle) {
  return std::abs(angle) < kLargestMedium ? reduceMedium(angle) : reduceLarge(angle);
}

}  // namespace pongsim::math
