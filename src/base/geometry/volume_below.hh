#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "pongsim/geometry/volume_moments.hh"
#include "pongsim/types.hh"

namespace pongsim::base {

// The parts of bodies below a plane: all points p with `up . p <= height`, where `up` is a unit vector in the frame of
// the body [m].

/// A box centred on the origin, given by its full side lengths.
VolumeMoments boxBelow(const Vector3& size, const Vector3& up, double height);

/// The half of a ball about the origin with z > 0.
VolumeMoments halfBallBelow(double radius, const Vector3& up, double height);

/// A cylinder along z, centred on the origin.
VolumeMoments cylinderBelow(double radius, double length, const Vector3& up, double height);

/// The inside of a closed surface; negative if its triangles are clockwise seen from outside.
VolumeMoments trianglesBelow(std::span<const Vector3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
                             const Vector3& up, double height);

}  // namespace pongsim::base
