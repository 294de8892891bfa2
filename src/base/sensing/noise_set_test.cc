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

TEST(NoiseSet, GivesAValueOtherNoiseUntilAReset) {
  const auto reading = [](NoiseSet& set, Noise& noise) {
    set.begin(std::chrono::milliseconds(1), 0.001);
    return noise.apply(0);
  };
  NoiseSet set(Random(1, "sensor"));
  Noise& height = set.add(ofDeviation(1), "height");
  Noise& speed = set.add(NoiseSettings(), "speed");
  EXPECT_EQ(set.name(1), "speed");
  const double before = reading(set, height);
  set.change(0, ofDeviation(3));
  set.change(1, ofDeviation(2));
  EXPECT_EQ(set.settings(0).standardDeviation, 3);
  EXPECT_DOUBLE_EQ(reading(set, height), 3 * before);
  const double ofSpeed = reading(set, speed);
  EXPECT_NE(ofSpeed, 0);
  // a saved state has it
  StateArchive saved;
  set.transfer(saved);
  const std::vector<std::byte> bytes = saved.take();
  set.reset(Random(1, "sensor"));
  EXPECT_EQ(reading(set, height), before);
  EXPECT_EQ(reading(set, speed), 0);
  EXPECT_FALSE(speed.isOn());
  StateArchive plain;
  set.transfer(plain);
  const std::vector<std::byte> plainBytes = plain.take();
  StateArchive given(bytes);
  set.transfer(given);
  EXPECT_DOUBLE_EQ(reading(set, height), 3 * before);
  EXPECT_EQ(reading(set, speed), ofSpeed);
  StateArchive taken(plainBytes);
  set.transfer(taken);
  EXPECT_EQ(reading(set, height), before);
  EXPECT_EQ(set.settings(1), NoiseSettings());
}

}  // namespace
}  // namespace pongsim
