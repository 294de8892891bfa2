#include "pongsim/noise.hh"

#include <cmath>

namespace pongsim {

Noise::Noise(const NoiseSettings& settings, Random random) : settings_(settings) {
  if (settings.type == NoiseSettings::Type::kNone) return;
  bias_ = random.normal(settings.biasMean, settings.biasStandardDeviation);
  if (random.uniform() < 0.5) bias_ = -bias_;
  random_ = random;
}

double Noise::apply(double value, double dt) {
  if (!random_) return value;

  // Ornstein-Uhlenbeck, exact for any dt. Gillespie, Exact numerical simulation of the Ornstein-Uhlenbeck process and
  // its integral, Phys. Rev. E 54, 1996; with the variance that Fortress gives it
  const double deviation = settings_.dynamicBiasStandardDeviation;
  const double tau = settings_.dynamicBiasCorrelationTime;
  if (deviation > 0 && tau > 0 && dt > 0) {
    const double spread = std::sqrt(-deviation * deviation * tau / 2 * std::expm1(-2 * dt / tau));
    bias_ = std::exp(-dt / tau) * bias_ + random_->normal(0, spread);
  }

  const double falsified = value + bias_ + random_->normal(settings_.mean, settings_.standardDeviation);
  if (settings_.type != NoiseSettings::Type::kGaussianQuantized || settings_.precision == 0) return falsified;
  return std::round(falsified / settings_.precision) * settings_.precision;
}

Noise3::Noise3(const NoiseSettings3& settings, Random& random)
    : axes_{Noise(settings[0], random.split("x")), Noise(settings[1], random.split("y")),
            Noise(settings[2], random.split("z"))} {}

Vector3 Noise3::apply(const Vector3& value, double dt) {
  const double x = axes_[0].apply(value.x(), dt);
  const double y = axes_[1].apply(value.y(), dt);
  return {x, y, axes_[2].apply(value.z(), dt)};
}

}  // namespace pongsim
