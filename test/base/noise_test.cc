#include "pongsim/noise.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim {
namespace {

NoiseSettings gaussian() {
  NoiseSettings settings;
  settings.type = NoiseSettings::Type::kGaussian;
  return settings;
}

TEST(Noise, LeavesAValueAsItIsWhereThereIsNone) {
  Noise none;
  EXPECT_EQ(none.apply(0.3, 1), 0.3);
  NoiseSettings settings = gaussian();
  settings.type = NoiseSettings::Type::kNone;
  settings.mean = 7;
  Noise ofNoType(settings, Random(1, "n"));
  EXPECT_EQ(ofNoType.apply(0.3, 1), 0.3);
}

TEST(Noise, IsOfItsMeanAndDeviation) {
  NoiseSettings settings = gaussian();
  settings.mean = 2;
  settings.standardDeviation = 0.5;
  Noise noise(settings, Random(1, "n"));
  constexpr int kCount = 20'000;
  double sum = 0, squares = 0;
  for (int i = 0; i < kCount; ++i) {
    const double error = noise.apply(10, 0.01) - 12;
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
    const double bias = noise.apply(0, 0.01);
    EXPECT_EQ(std::abs(bias), 3);
    EXPECT_EQ(noise.apply(0, 0.01), bias);
    ++(bias > 0 ? up : down);
  }
  EXPECT_GT(up, 10);
  EXPECT_GT(down, 10);
}

TEST(Noise, HasABiasThatWanders) {
  NoiseSettings settings = gaussian();
  settings.dynamicBiasStandardDeviation = 0.5;
  settings.dynamicBiasCorrelationTime = 2;
  Noise noise(settings, Random(1, "n"));
  EXPECT_EQ(noise.apply(0, 0), 0);
  double squares = 0;
  constexpr int kCount = 20'000;
  // steps so long that each draw is on its own: variance s^2 tau / 2
  for (int i = 0; i < kCount; ++i) squares += std::pow(noise.apply(0, 100), 2);
  EXPECT_NEAR(squares / kCount, 0.25, 0.01);
  const double before = noise.apply(0, 100);
  EXPECT_NEAR(noise.apply(0, 1e-9), before, 1e-3);
}

TEST(Noise, IsRoundedWhereItIsQuantized) {
  NoiseSettings settings = gaussian();
  settings.type = NoiseSettings::Type::kGaussianQuantized;
  settings.precision = 0.25;
  settings.standardDeviation = 1;
  Noise noise(settings, Random(1, "n"));
  for (int i = 0; i < 100; ++i) {
    const double quarters = noise.apply(0.1, 0.01) * 4;
    EXPECT_EQ(quarters, std::round(quarters));
  }
}

TEST(Noise, DiffersFromAxisToAxis) {
  NoiseSettings settings = gaussian();
  settings.standardDeviation = 1;
  Random random(1, "n");
  Noise3 noise({settings, NoiseSettings(), settings}, random);
  const Vector3 value = noise.apply(Vector3::Zero(), 0.01);
  EXPECT_NE(value.x(), value.z());
  EXPECT_NE(value.x(), 0);
  EXPECT_EQ(value.y(), 0);
}

}  // namespace
}  // namespace pongsim
