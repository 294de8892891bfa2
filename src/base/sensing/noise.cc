#include "pongsim/sensing/noise.hh"

#include <cmath>
#include <cstdint>

#include "pongsim/math.hh"

namespace pongsim {

Noise::Noise(const NoiseSettings& settings, Random random) : settings_(settings) {
  if (settings.type == NoiseSettings::Type::kNone) return;
  bias_ = random.normal(settings.biasMean, settings.biasStandardDeviation);
  if (random.uniform() < 0.5) bias_ = -bias_;
  stream_ = draws_ = random;
}

void Noise::begin(Time time, double dt) {
  if (!stream_) return;
  draws_ = stream_->at(static_cast<std::uint64_t>(time.count()));

  // Ornstein-Uhlenbeck process, exact for any dt, with Fortress's variance. Gillespie, Exact numerical simulation of
  // the Ornstein-Uhlenbeck process and its integral, Phys. Rev. E 54, 1996
  const double deviation = settings_.dynamicBiasStandardDeviation;
  const double tau = settings_.dynamicBiasCorrelationTime;
  if (deviation > 0 && tau > 0 && dt > 0) {
    const double spread = std::sqrt(-deviation * deviation * tau / 2 * math::expm1(-2 * dt / tau));
    bias_ = math::exp(-dt / tau) * bias_ + draws_->normal(0, spread);
  }
}

double Noise::apply(double value) {
  if (!draws_) return value;
  const double falsified = value + bias_ + draws_->normal(settings_.mean, settings_.standardDeviation);
  if (settings_.type != NoiseSettings::Type::kGaussianQuantized || settings_.precision == 0) return falsified;
  return std::round(falsified / settings_.precision) * settings_.precision;
}

}  // namespace pongsim
