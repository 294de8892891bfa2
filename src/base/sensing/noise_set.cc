#include "pongsim/sensing/noise_set.hh"

namespace pongsim {

namespace {

void transferSettings(StateArchive& archive, NoiseSettings& settings) {
  archive(settings.type, NoiseSettings::Type::kGaussianQuantized);
  archive(settings.mean);
  archive(settings.biasMean);
  for (double* number :
       {&settings.standardDeviation, &settings.biasStandardDeviation, &settings.dynamicBiasStandardDeviation,
        &settings.dynamicBiasCorrelationTime, &settings.precision}) {
    archive(*number);
    archive.check(*number >= 0);
  }
}

}  // namespace

Noise& NoiseSet::add(const NoiseSettings& settings, std::string_view name) {
  return noises_.emplace_back(NamedNoise{settings, std::string(name), random_.split(name)}).noise;
}

Noise3 NoiseSet::add(const NoiseSettings3& settings, const std::string& name) {
  return Noise3({&add(settings[0], name + " x"), &add(settings[1], name + " y"), &add(settings[2], name + " z")});
}

void NoiseSet::begin(Time time, double dt) {
  for (NamedNoise& each : noises_) each.noise.begin(time, dt);
}

std::size_t NoiseSet::size() const { return noises_.size(); }

const std::string& NoiseSet::name(std::size_t number) const { return noises_[number].name; }

const NoiseSettings& NoiseSet::settings(std::size_t number) const { return noises_[number].settings; }

void NoiseSet::change(std::size_t number, const NoiseSettings& settings) {
  NamedNoise& changed = noises_[number];
  changed.settings = settings;
  changed.noise = Noise(settings, changed.stream);
}

void NoiseSet::transfer(StateArchive& archive) {
  for (std::size_t i = 0; i < noises_.size(); ++i) {
    NoiseSettings settings = noises_[i].settings;
    bool isChanged = settings != noises_[i].ofFile;
    archive(isChanged);
    if (!isChanged) settings = noises_[i].ofFile;
    if (isChanged) transferSettings(archive, settings);
    if (settings != noises_[i].settings) change(i, settings);
    noises_[i].noise.transfer(archive);
  }
}

void NoiseSet::reset(const Random& random) {
  random_ = random;
  for (std::size_t i = 0; i < noises_.size(); ++i) {
    noises_[i].stream = random_.split(noises_[i].name);
    change(i, noises_[i].ofFile);
  }
}

}  // namespace pongsim
