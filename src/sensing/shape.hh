#pragma once

#include <limits>
#include <optional>
#include <variant>

#include "description/geometry.hh"
#include "pongsim/types.hh"

namespace pongsim::sensing {

/// Position on a line without a hit.
inline constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// The points `origin + t * direction`. The direction may have any length but zero.
struct Line {
  Vector3 origin;
  Vector3 direction;
};

/// The part of a line inside a body, in lengths of its direction: at `enter` it hits the surface from outside, at
/// `leave` from inside. Infinite without a hit.
struct Passage {
  double enter;
  double leave;
};

/// A rectangle in the plane z = 0, centred on its frame; its outside is towards z.
struct Sheet {
  /// Half lengths along x and y [m].
  Eigen::Vector2d half;
};

/// A body with a surface given by a formula.
using Shape = std::variant<description::Box, description::Sphere, description::Cylinder, description::Capsule,
                           description::Ellipsoid, description::Cone, Sheet>;

/// @param line In the frame of the shape.
/// @return Nothing if the line misses the shape.
std::optional<Passage> passage(const Shape& shape, const Line& line);

/// @return The bounding box in the shape's frame.
Eigen::AlignedBox3d boundsOf(const Shape& shape);

/// @param half Half lengths of the box [m].
std::optional<Passage> boxPassage(const Vector3& half, const Line& line);

/// @return The first hit on the line, not before `from`, from outside, or from either side if `seesInside`; infinity
/// without one.
double firstSeen(const Passage& passage, double from, bool seesInside);

}  // namespace pongsim::sensing
