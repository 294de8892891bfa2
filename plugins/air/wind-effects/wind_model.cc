#include "wind_model.hh"

#include <algorithm>
#include <numbers>

#include "pongsim/math.hh"

namespace pongsim {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// One step of a low-pass filter. A rise time shorter than the step ends within it.
double approach(double value, double goal, double riseTime, double dt) {
  const double share = std::min(dt / riseTime, 1.0);
  return (1 - share) * value + share * goal;
}

double wave(const WindPartSettings& part, double seconds) {
  return part.waveAmplitude * math::sin(2 * std::numbers::pi * seconds / part.wavePeriod);
}

}  // namespace

WindModel::WindModel(const WindSettings& settings, const Random& random)
    : settings_(settings),
      noises_(random),
      magnitudeNoise_(&noises_.add(settings.magnitude.noise, "magnitude")),
      directionNoise_(&noises_.add(settings.direction.noise, "direction")),
      verticalNoise_(&noises_.add(settings.vertical.noise, "vertical")) {}

Vector3 WindModel::update(const Vector3& mean, Time time, double dt) {
  noises_.begin(time, dt);
  const double seconds = toSeconds(time);
  magnitude_ = approach(magnitude_, math::hypot(mean.x(), mean.y()), settings_.magnitude.riseTime, dt);
  const double goal = math::atan2(mean.y(), mean.x()) / kDegree;
  direction_ = direction_ ? approach(*direction_, goal, settings_.direction.riseTime, dt) : goal;
  vertical_ = approach(vertical_, mean.z(), settings_.vertical.riseTime, dt);

  const double magnitude = magnitudeNoise_->apply(magnitude_ + wave(settings_.magnitude, seconds) * magnitude_);
  const double direction = directionNoise_->apply(*direction_ + wave(settings_.direction, seconds)) * kDegree;
  return {magnitude * math::cos(direction), magnitude * math::sin(direction), verticalNoise_->apply(vertical_)};
}

void WindModel::reset(const Random& random) {
  noises_.reset(random);
  magnitude_ = vertical_ = 0;
  direction_.reset();
}

void WindModel::transfer(StateArchive& archive) {
  noises_.transfer(archive);
  archive(magnitude_);
  archive(direction_);
  archive(vertical_);
}

}  // namespace pongsim
