#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "pongsim/geometry/volume_moments.hh"
#include "pongsim/types.hh"

namespace pongsim::base {

// The parts of bodies below a plane: all points p with `up . p <= height`, where `up` is a unit vector in the frame of
// the body [m].

/// Of a box centred on the origin, with its full lengths.
VolumeMoments boxBelow(const Vector3& size, const Vector3& up, double height);

/// Of the half of a ball about the origin with z above zero.
VolumeMoments halfBallBelow(double radius, const Vector3& up, double height);

/// Of a cylinder about z, centred on the origin.
VolumeMoments cylinderBelow(double radius, double length, const Vector3& up, double height);

/// Of what a closed surface encloses; negative where its triangles turn clockwise seen from outside.
VolumeMoments trianglesBelow(std::span<const Vector3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
                             const Vector3& up, double height);

}  // namespace pongsim::base
