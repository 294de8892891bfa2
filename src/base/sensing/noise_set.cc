#include "pongsim/sensing/noise_set.hh"

namespace pongsim {

Noise& NoiseSet::add(const NoiseSettings& settings, std::string_view name) {
  return parts_.emplace_back(Part{settings, std::string(name), Noise(settings, random_.split(name))}).noise;
}

Noise3 NoiseSet::add(const NoiseSettings3& settings, const std::string& name) {
  return Noise3({&add(settings[0], name + " x"), &add(settings[1], name + " y"), &add(settings[2], name + " z")});
}

void NoiseSet::begin(Time time, double dt) {
  for (Part& part : parts_) part.noise.begin(time, dt);
}

void NoiseSet::transfer(StateArchive& archive) {
  for (Part& part : parts_) part.noise.transfer(archive);
}

void NoiseSet::reset(const Random& random) {
  random_ = random;
  for (Part& part : parts_) part.noise = Noise(part.settings, random_.split(part.name));
}

}  // namespace pongsim
