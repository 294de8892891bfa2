#pragma once

#include <string>
#include <variant>

#include "pongsim/types.hh"

namespace pongsim::description {

/// `<empty>`: no shape.
struct Empty {};

/// Centred on its frame. Size: full lengths along x, y, z [m].
struct Box {
  Vector3 size{1, 1, 1};
};

/// Centred on its frame [m].
struct Sphere {
  double radius = 1;
};

/// Centred on its frame, its axis along z [m].
struct Cylinder {
  double radius = 1;
  double length = 1;
};

/// Through the origin of its frame. As a collision shape it has no end; `size` is that of its picture [m].
struct Plane {
  Vector3 normal = Vector3::UnitZ();
  Eigen::Vector2d size{1, 1};
};

/// A shape of the format that pongsim does not build yet; `kind` is its element's name.
struct OtherGeometry {
  std::string kind;
};

using Geometry = std::variant<Empty, Box, Sphere, Cylinder, Plane, OtherGeometry>;

}  // namespace pongsim::description
