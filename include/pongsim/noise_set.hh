#pragma once

#include <array>
#include <deque>
#include <string>
#include <string_view>

#include "pongsim/export.hh"
#include "pongsim/noise.hh"
#include "pongsim/noise_settings.hh"
#include "pongsim/random.hh"
#include "pongsim/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Noise along three axes, which a `NoiseSet` owns.
class Noise3 {
 public:
  explicit Noise3(const std::array<Noise*, 3>& axes) : axes_(axes) {}

  /// As `Noise::apply`.
  Vector3 apply(const Vector3& value) const {
    const double x = axes_[0]->apply(value.x());
    const double y = axes_[1]->apply(value.y());
    return {x, y, axes_[2]->apply(value.z())};
  }

 private:
  std::array<Noise*, 3> axes_;
};

/// All that falsifies a sensor's reading.
class PONGSIM_API NoiseSet {
 public:
  /// @param random The stream of the sensor, from which each noise gets its own.
  explicit NoiseSet(const Random& random) : random_(random) {}
  // sensors hold on to what is in it
  NoiseSet(const NoiseSet&) = delete;
  NoiseSet& operator=(const NoiseSet&) = delete;

  /// @param name Of the value, by which its stream differs from the others'.
  /// @return A noise that lives as long as the set.
  Noise& add(const NoiseSettings& settings, std::string_view name);
  Noise3 add(const NoiseSettings3& settings, const std::string& name);

  /// As the functions of `Noise`, for all of them.
  void begin(Time time, double dt);
  void transfer(StateArchive& archive);

  /// Begins anew, with the streams of what was added split off from this one as they were from that at first.
  void reset(const Random& random);

 private:
  Random random_;
  struct Part {
    NoiseSettings settings;
    std::string name;
    Noise noise;
  };
  // they stay where they are
  std::deque<Part> parts_;
};

}  // namespace pongsim
