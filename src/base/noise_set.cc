#include "pongsim/noise_set.hh"

namespace pongsim {

Noise& NoiseSet::add(const NoiseSettings& settings, std::string_view name) {
  return noises_.emplace_back(settings, random_.split(name));
}

Noise3 NoiseSet::add(const NoiseSettings3& settings, const std::string& name) {
  return Noise3({&add(settings[0], name + " x"), &add(settings[1], name + " y"), &add(settings[2], name + " z")});
}

void NoiseSet::begin(Time time, double dt) {
  for (Noise& noise : noises_) noise.begin(time, dt);
}

void NoiseSet::reset() {
  for (Noise& noise : noises_) noise.reset();
}

void NoiseSet::transfer(StateArchive& archive) {
  for (Noise& noise : noises_) noise.transfer(archive);
}

}  // namespace pongsim
