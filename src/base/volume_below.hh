#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "pongsim/types.hh"

namespace pongsim::base {

/// A volume [m^3] and what it gives multiplied by its centroid [m^4]: both add up.
struct VolumeMoments {
  double volume = 0;
  Vector3 first = Vector3::Zero();

  VolumeMoments& operator+=(const VolumeMoments& other) {
    volume += other.volume;
    first += other.first;
    return *this;
  }
};

// The parts of bodies below a plane: all points p with `up . p <= height`, where `up` is a unit vector in the frame of
// the body [m].

/// Of a ball about the origin.
VolumeMoments ballBelow(double radius, const Vector3& up, double height);

/// Of the half of a ball about the origin with z above zero.
VolumeMoments halfBallBelow(double radius, const Vector3& up, double height);

/// Of a cylinder about z, centred on the origin.
VolumeMoments cylinderBelow(double radius, double length, const Vector3& up, double height);

/// Of what a closed surface encloses; negative where its triangles turn clockwise seen from outside.
VolumeMoments trianglesBelow(std::span<const Vector3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
                             const Vector3& up, double height);

}  // namespace pongsim::base
