#include "sonar_link.hh"

#include <numbers>

#include "pongsim/math.hh"

namespace pongsim {

namespace {

double decibels(double ratio) { return 10 * math::log(ratio) / std::numbers::ln10; }

}  // namespace

double signalToNoise(const SonarLinkSettings& settings, double distance) {
  // level of a source of 1 W at 1 m, against 1 uPa
  constexpr double kLevelOfOneWatt = 170.8;
  return kLevelOfOneWatt + decibels(settings.sourcePower) - 2 * decibels(distance) - settings.noiseLevel;
}

double packetLoss(const SonarLinkSettings& settings, double distance, std::uint64_t bytes) {
  const double ratio = signalToNoise(settings, distance) / settings.spectralEfficiency;
  const double bitErrorRate = 0.5 * math::erfc(ratio);
  if (bytes == 0) return 0;
  if (bitErrorRate >= 1) return 1;
  return -math::expm1(static_cast<double>(bytes) * math::log1p(-bitErrorRate));
}

}  // namespace pongsim
