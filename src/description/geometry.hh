#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <variant>

#include "description/triangle_mesh.hh"
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

/// A cylinder of that length along z with half a ball on each end [m].
struct Capsule {
  double radius = 0.5;
  double length = 1;
};

/// Centred on its frame. Radii along x, y, z [m].
struct Ellipsoid {
  Vector3 radii{1, 1, 1};
};

/// Through the origin of its frame. As a collision shape it has no end; `size` is that of its picture [m].
struct Plane {
  Vector3 normal = Vector3::UnitZ();
  Eigen::Vector2d size{1, 1};
  bool operator==(const Plane&) const = default;
};

/// `<mesh>`: triangles from a file.
struct Mesh {
  /// As it stands in the description's file.
  std::string uri;
  /// What it names; empty where that is not there.
  std::filesystem::path file;
  /// The one part of the file that is meant; empty: all of it.
  std::string submesh;
  /// The part's bounding box is moved to have its centre in the origin.
  bool isCentered = false;
  /// Along each axis; negative mirrors, never zero.
  Vector3 scale{1, 1, 1};
  /// Before scaling, shared by all that show the same. Null where it could not be read, and for visuals, which are not
  /// read.
  std::shared_ptr<const TriangleMesh> triangles;
};

/// `<heightmap>`: ground whose height is the brightness of an image.
struct Heightmap {
  /// As it stands in the description's file.
  std::string uri;
  /// What it names; empty where that is not there.
  std::filesystem::path file;
  /// Of the whole, from the darkest that a pixel can be to the brightest that there is [m].
  Vector3 size{1, 1, 1};
  /// Of its middle, at the height of black [m].
  Vector3 position = Vector3::Zero();
  /// With size and position. Null where the image could not be read, and for visuals.
  std::shared_ptr<const TriangleMesh> triangles;
};

/// A shape of the format that pongsim does not build yet; `kind` is its element's name.
struct OtherGeometry {
  std::string kind;
  bool operator==(const OtherGeometry&) const = default;
};

using Geometry = std::variant<Empty, Box, Sphere, Cylinder, Capsule, Ellipsoid, Plane, Mesh, Heightmap, OtherGeometry>;

}  // namespace pongsim::description
