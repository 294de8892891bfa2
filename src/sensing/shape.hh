#pragma once

#include <limits>
#include <optional>
#include <variant>

#include "description/geometry.hh"
#include "pongsim/types.hh"

namespace pongsim::sensing {

/// A place on a line that is none.
inline constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// The points `origin + t * direction`. The direction may have any length but zero.
struct Line {
  Vector3 origin;
  Vector3 direction;
};

/// The part of a line that lies within a body, in lengths of its direction: at `enter` it meets the body's surface from
/// outside, at `leave` from inside. Either is infinite where it does not.
struct Passage {
  double enter;
  double leave;
};

/// A rectangle in the plane z = 0, centred on its frame. Its outside is towards z.
struct Sheet {
  /// Half of its size along x and y [m].
  Eigen::Vector2d half;
};

/// A body whose surface a formula gives.
using Shape = std::variant<description::Box, description::Sphere, description::Cylinder, description::Capsule,
                           description::Ellipsoid, Sheet>;

/// @param line In the frame of the shape.
/// @return Nothing where the line passes by.
std::optional<Passage> passage(const Shape& shape, const Line& line);

/// @return The smallest box along the axes of the shape's frame that holds it.
Eigen::AlignedBox3d boundsOf(const Shape& shape);

/// @param half Half of the box's size [m].
std::optional<Passage> boxPassage(const Vector3& half, const Line& line);

/// @return The first point of the line, not before `from`, where it meets the surface from outside, or from either side
/// if `seesInside`; infinity where there is none.
double firstSeen(const Passage& passage, double from, bool seesInside);

}  // namespace pongsim::sensing
