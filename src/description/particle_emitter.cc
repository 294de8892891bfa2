#include "description/particle_emitter.hh"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pongsim::description {

namespace {

// beyond it, products of a speed and an age lose their meaning
constexpr double kLargest = 1e6;

/// @return Whether all components are finite and from zero to one.
bool isColor(const Color& color) {
  for (const float share : {color.red, color.green, color.blue, color.alpha}) {
    if (!(share >= 0 && share <= 1)) return false;
  }
  return true;
}

}  // namespace

std::string faultOf(const ParticleEmitter& emitter) {
  const auto isNotNegative = [](double value) { return value >= 0 && value <= kLargest; };
  const auto areNotNegative = [&](const Vector3& values) { return std::ranges::all_of(values, isNotNegative); };
  const std::pair<const char*, bool> notNegative[] = {{"size", areNotNegative(emitter.size)},
                                                      {"particle_size", areNotNegative(emitter.particleSize)},
                                                      {"rate", isNotNegative(emitter.rate)},
                                                      {"lifetime", isNotNegative(emitter.lifetime)},
                                                      {"scale_rate", isNotNegative(emitter.scaleRate)}};
  for (const auto& [name, is] : notNegative) {
    if (!is) return "its <" + std::string(name) + "> is not between 0 and 1e6";
  }
  const std::pair<const char*, double> bounded[] = {
      {"min_velocity", emitter.minVelocity}, {"max_velocity", emitter.maxVelocity}, {"duration", emitter.duration}};
  for (const auto& [name, value] : bounded) {
    if (!(std::abs(value) <= kLargest)) return "its <" + std::string(name) + "> is not between -1e6 and 1e6";
  }
  if (!(emitter.scatterRatio >= 0 && emitter.scatterRatio <= 1)) {
    return "its <particle_scatter_ratio> is not between 0 and 1";
  }
  if (!isColor(emitter.colorStart)) return "its <color_start> has a component that is not between 0 and 1";
  if (!isColor(emitter.colorEnd)) return "its <color_end> has a component that is not between 0 and 1";
  return {};
}

}  // namespace pongsim::description
