#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <string>
#include <string_view>

#include "pongsim/export.hh"
#include "pongsim/random.hh"
#include "pongsim/sensing/noise.hh"
#include "pongsim/sensing/noise_settings.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Noise along three axes, owned by a `NoiseSet`.
class Noise3 {
 public:
  explicit Noise3(const std::array<Noise*, 3>& axes) : axes_(axes) {}

  /// Like `Noise::apply`.
  Vector3 apply(const Vector3& value) const {
    const double x = axes_[0]->apply(value.x());
    const double y = axes_[1]->apply(value.y());
    return {x, y, axes_[2]->apply(value.z())};
  }

 private:
  std::array<Noise*, 3> axes_;
};

/// All noise of a sensor.
class PONGSIM_API NoiseSet {
 public:
  /// @param random The sensor's stream, which is split for each noise.
  explicit NoiseSet(const Random& random) : random_(random) {}
  // sensors keep references to its noises
  NoiseSet(const NoiseSet&) = delete;
  NoiseSet& operator=(const NoiseSet&) = delete;

  /// @param name Of the value; selects its random stream.
  /// @return The noise, valid as long as the set.
  Noise& add(const NoiseSettings& settings, std::string_view name);
  Noise3 add(const NoiseSettings3& settings, const std::string& name);

  /// Like the functions of `Noise`, for all of them.
  void begin(Time time, double dt);
  void transfer(StateArchive& archive);

  std::size_t size() const;
  const std::string& name(std::size_t number) const;
  const NoiseSettings& settings(std::size_t number) const;
  /// Gives a value other noise until the next `reset`. Its offset begins again.
  void change(std::size_t number, const NoiseSettings& settings);

  /// Starts again with the settings of the start, and with all streams split off from this one as at first.
  void reset(const Random& random);

 private:
  Random random_;
  struct NamedNoise {
    NoiseSettings ofFile;
    std::string name;
    /// What all its noise since the last reset is drawn from.
    Random stream;
    Noise noise = Noise(ofFile, stream);
    NoiseSettings settings = ofFile;
  };
  // a deque keeps references to its elements valid
  std::deque<NamedNoise> noises_;
};

}  // namespace pongsim
