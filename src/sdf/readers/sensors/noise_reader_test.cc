#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

using Type = NoiseSettings::Type;

/// Loads an IMU whose noise about x is that; it begins in line 5, column 1.
Loaded loadNoise(const std::string& noise) {
  return loadLink("<sensor name='s' type='imu'><imu><angular_velocity><x>\n" + noise +
                  "</x></angular_velocity></imu></sensor>");
}

NoiseSettings noiseOf(const Loaded& loaded) {
  return std::get<ImuSettings>(loaded.model().links.at(0).sensors.at(0).settings).angularVelocity[0];
}

TEST(Noise, IsReadInAllItsParts) {
  const Loaded loaded = loadNoise(
      "<noise type='gaussian_quantized'><mean>1</mean><stddev>2</stddev><bias_mean>3</bias_mean>"
      "<bias_stddev>4</bias_stddev><dynamic_bias_stddev>5</dynamic_bias_stddev>"
      "<dynamic_bias_correlation_time>6</dynamic_bias_correlation_time><precision>7</precision></noise>");
  EXPECT_EQ(loaded.messages, Messages());
  const NoiseSettings noise = noiseOf(loaded);
  EXPECT_EQ(noise.type, Type::kGaussianQuantized);
  EXPECT_EQ(noise.mean, 1);
  EXPECT_EQ(noise.standardDeviation, 2);
  EXPECT_EQ(noise.biasMean, 3);
  EXPECT_EQ(noise.biasStandardDeviation, 4);
  EXPECT_EQ(noise.dynamicBiasStandardDeviation, 5);
  EXPECT_EQ(noise.dynamicBiasCorrelationTime, 6);
  EXPECT_EQ(noise.precision, 7);
}

TEST(Noise, IsNoneWithoutAType) {
  EXPECT_EQ(noiseOf(loadNoise("<noise><stddev>2</stddev></noise>")).type, Type::kNone);
}

TEST(Noise, OfAnUnknownTypeIsAnError) {
  EXPECT_EQ(loadNoise("<noise type='gausian'/>").messages,
            Messages{"t.sdf:5:8: error: <noise> has the unknown type 'gausian' | did you mean 'gaussian'?"});
}

TEST(Noise, HasNoNegativeDeviation) {
  EXPECT_EQ(loadNoise("<noise type='gaussian'><stddev>-1</stddev></noise>").messages,
            Messages{"t.sdf:5:24: error: <stddev> is '-1', which is not a finite, non-negative number"});
}

}  // namespace
}  // namespace pongsim::sdf::test
