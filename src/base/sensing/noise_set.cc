#include "pongsim/sensing/noise_set.hh"

namespace pongsim {

Noise& NoiseSet::add(const NoiseSettings& settings, std::string_view name) {
  return noises_.emplace_back(NamedNoise{settings, std::string(name), Noise(settings, random_.split(name))}).noise;
}

Noise3 NoiseSet::add(const NoiseSettings3& settings, const std::string& name) {
  return Noise3({&add(settings[0], name + " x"), &add(settings[1], name + " y"), &add(settings[2], name + " z")});
}

void NoiseSet::begin(Time time, double dt) {
  for (NamedNoise& each : noises_) each.noise.begin(time, dt);
}

void NoiseSet::transfer(StateArchive& archive) {
  for (NamedNoise& each : noises_) each.noise.transfer(archive);
}

void NoiseSet::reset(const Random& random) {
  random_ = random;
  for (NamedNoise& each : noises_) each.noise = Noise(each.settings, random_.split(each.name));
}

}  // namespace pongsim
