#pragma once

#include <string>
#include <variant>

#include "pongsim/types.hh"

namespace pongsim::description {

/// `<empty>`: no shape.
struct Empty {
  bool operator==(const Empty&) const = default;
};

/// Centred on its frame. Size: full lengths along x, y, z [m].
struct Box {
  Vector3 size{1, 1, 1};
  bool operator==(const Box&) const = default;
};

/// Centred on its frame [m].
struct Sphere {
  double radius = 1;
  bool operator==(const Sphere&) const = default;
};

/// Centred on its frame, its axis along z [m].
struct Cylinder {
  double radius = 1;
  double length = 1;
  bool operator==(const Cylinder&) const = default;
};

/// Through the origin of its frame. As a collision shape it has no end; `size` is that of its picture [m].
struct Plane {
  Vector3 normal = Vector3::UnitZ();
  Eigen::Vector2d size{1, 1};
  bool operator==(const Plane&) const = default;
};

/// A shape of the format that pongsim does not build yet; `kind` is its element's name.
struct OtherGeometry {
  std::string kind;
  bool operator==(const OtherGeometry&) const = default;
};

using Geometry = std::variant<Empty, Box, Sphere, Cylinder, Plane, OtherGeometry>;

}  // namespace pongsim::description
