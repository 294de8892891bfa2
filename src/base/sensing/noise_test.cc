#include "pongsim/sensing/noise.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <vector>

namespace pongsim {
namespace {

NoiseSettings gaussian() {
  NoiseSettings settings;
  settings.type = NoiseSettings::Type::kGaussian;
  return settings;
}

/// @return Noise whose bias wanders.
NoiseSettings wandering() {
  NoiseSettings settings = gaussian();
  settings.dynamicBiasStandardDeviation = 0.5;
  settings.dynamicBiasCorrelationTime = 2;
  return settings;
}

/// @return What a value becomes in the reading at that millisecond.
double readingOf(Noise& noise, int millisecond, double dt = 0.01, double value = 0) {
  noise.begin(std::chrono::milliseconds(millisecond), dt);
  return noise.apply(value);
}

TEST(Noise, LeavesAValueAsItIsWhereThereIsNone) {
  Noise none;
  none.begin(Time(5), 1);
  EXPECT_EQ(none.apply(0.3), 0.3);
  NoiseSettings settings = gaussian();
  settings.type = NoiseSettings::Type::kNone;
  settings.mean = 7;
  Noise ofNoType(settings, Random(1, "n"));
  ofNoType.begin(Time(5), 1);
  EXPECT_EQ(ofNoType.apply(0.3), 0.3);
}

TEST(Noise, IsOfItsMeanAndDeviation) {
  NoiseSettings settings = gaussian();
  settings.mean = 2;
  settings.standardDeviation = 0.5;
  Noise noise(settings, Random(1, "n"));
  constexpr int kCount = 20'000;
  double sum = 0, squares = 0;
  for (int i = 0; i < kCount; ++i) {
    const double error = readingOf(noise, i, 0.01, 10) - 12;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / kCount, 0, 0.02);
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.5, 0.02);
}

TEST(Noise, HasABiasThatIsDrawnOnce) {
  NoiseSettings settings = gaussian();
  settings.biasMean = 3;
  int up = 0, down = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Noise noise(settings, Random(seed, "n"));
    const double bias = readingOf(noise, 1);
    EXPECT_EQ(std::abs(bias), 3);
    EXPECT_EQ(readingOf(noise, 2), bias);
    ++(bias > 0 ? up : down);
  }
  EXPECT_GT(up, 10);
  EXPECT_GT(down, 10);
}

TEST(Noise, HasABiasThatWanders) {
  Noise noise(wandering(), Random(1, "n"));
  EXPECT_EQ(readingOf(noise, 0, 0), 0);
  double squares = 0;
  constexpr int kCount = 20'000;
  // steps so long that each draw is on its own: variance s^2 tau / 2
  for (int i = 0; i < kCount; ++i) squares += std::pow(readingOf(noise, i, 100), 2);
  EXPECT_NEAR(squares / kCount, 0.25, 0.01);
  const double before = readingOf(noise, kCount, 100);
  EXPECT_NEAR(readingOf(noise, kCount + 1, 1e-9), before, 1e-3);
}

TEST(Noise, IsRoundedWhereItIsQuantized) {
  NoiseSettings settings = gaussian();
  settings.type = NoiseSettings::Type::kGaussianQuantized;
  settings.precision = 0.25;
  settings.standardDeviation = 1;
  Noise noise(settings, Random(1, "n"));
  for (int i = 0; i < 100; ++i) {
    const double quarters = readingOf(noise, i, 0.01, 0.1) * 4;
    EXPECT_EQ(quarters, std::round(quarters));
  }
}

TEST(Noise, OfAReadingDependsOnItsTimeOnly) {
  NoiseSettings settings = gaussian();
  settings.standardDeviation = 1;
  Noise asked(settings, Random(1, "n")), unasked(settings, Random(1, "n"));
  double last = 0;
  for (int i = 0; i <= 10; ++i) last = readingOf(asked, i);
  EXPECT_EQ(readingOf(unasked, 10), last);
  EXPECT_NE(readingOf(unasked, 11), last);
  // several values of one reading differ
  EXPECT_NE(unasked.apply(0), unasked.apply(0));
}

TEST(Noise, WandersTheSameWayWhetherOrNotAValueIsAskedFor) {
  Noise asked(wandering(), Random(1, "n")), unasked(wandering(), Random(1, "n"));
  for (int i = 0; i < 10; ++i) readingOf(asked, i, 0.1);
  for (int i = 0; i < 10; ++i) unasked.begin(std::chrono::milliseconds(i), 0.1);
  EXPECT_EQ(readingOf(asked, 10, 0.1), readingOf(unasked, 10, 0.1));
}

TEST(Noise, GoesOnWhereItWas) {
  Noise noise(wandering(), Random(1, "n"));
  const double first = readingOf(noise, 1, 0.1);
  StateArchive saved;
  noise.transfer(saved);
  const double second = readingOf(noise, 2, 0.1);
  EXPECT_NE(second, first);
  Noise other(wandering(), Random(1, "n"));
  const std::vector<std::byte> bytes = saved.take();
  StateArchive given(bytes);
  other.transfer(given);
  EXPECT_EQ(readingOf(other, 2, 0.1), second);
}

}  // namespace
}  // namespace pongsim
