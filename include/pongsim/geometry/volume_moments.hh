#pragma once

#include "pongsim/types.hh"

namespace pongsim {

/// A volume [m^3] and the volume times its centroid [m^4]. Both are additive.
struct VolumeMoments {
  double volume = 0;
  Vector3 first = Vector3::Zero();

  VolumeMoments& operator+=(const VolumeMoments& other) {
    volume += other.volume;
    first += other.first;
    return *this;
  }
};

}  // namespace pongsim
