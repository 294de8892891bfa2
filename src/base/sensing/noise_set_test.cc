#include "pongsim/sensing/noise_set.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

namespace pongsim {
namespace {

NoiseSettings ofDeviation(double deviation) {
  NoiseSettings settings;
  settings.type = NoiseSettings::Type::kGaussian;
  settings.standardDeviation = deviation;
  return settings;
}

TEST(NoiseSet, GivesEachValueAStreamOfItsOwn) {
  NoiseSet set(Random(1, "sensor"));
  Noise& height = set.add(ofDeviation(1), "height");
  Noise& speed = set.add(ofDeviation(1), "speed");
  const Noise3 field = set.add({ofDeviation(1), NoiseSettings(), ofDeviation(1)}, "field");
  set.begin(std::chrono::milliseconds(1), 0.001);
  const Vector3 value = field.apply(Vector3::Zero());
  EXPECT_NE(height.apply(0), speed.apply(0));
  EXPECT_NE(value.x(), value.z());
  EXPECT_NE(value.x(), 0);
  EXPECT_EQ(value.y(), 0);
}

TEST(NoiseSet, BeginsAnewAndGoesOnWhereItWas) {
  NoiseSettings wandering = ofDeviation(1);
  wandering.dynamicBiasStandardDeviation = 1;
  wandering.dynamicBiasCorrelationTime = 1;
  const auto readingAt = [](int millisecond, NoiseSet& set, Noise& noise) {
    set.begin(std::chrono::milliseconds(millisecond), 0.1);
    return noise.apply(0);
  };
  NoiseSet set(Random(1, "sensor"));
  Noise& noise = set.add(wandering, "height");
  const double first = readingAt(1, set, noise);
  StateArchive saved;
  set.transfer(saved);
  const double second = readingAt(2, set, noise);
  set.reset(Random(2, "sensor"));
  EXPECT_NE(readingAt(1, set, noise), first);
  set.reset(Random(1, "sensor"));
  EXPECT_EQ(readingAt(1, set, noise), first);
  const std::vector<std::byte> bytes = saved.take();
  StateArchive given(bytes);
  set.transfer(given);
  EXPECT_EQ(readingAt(2, set, noise), second);
}

}  // namespace
}  // namespace pongsim
