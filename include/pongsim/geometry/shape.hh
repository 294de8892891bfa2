#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <variant>

#include "pongsim/types.hh"

namespace pongsim {

// Shapes of collisions as values, each in the frame of its collision; lengths in metres.

/// No shape: an `<empty>`, or a mesh that can't be read.
struct NoShape {};

/// Centred on its frame, with side lengths along x, y, z.
struct BoxShape {
  Vector3 size{1, 1, 1};
};

/// Centred on its frame.
struct SphereShape {
  double radius = 1;
};

/// Centred on its frame, its axis along z.
struct CylinderShape {
  double radius = 1;
  double length = 1;
};

/// A cylinder of that length along z with a hemisphere on each end, centred on its frame.
struct CapsuleShape {
  double radius = 0.5;
  double length = 1;
};

/// Centred on its frame, with radii along x, y, z.
struct EllipsoidShape {
  Vector3 radii{1, 1, 1};
};

/// An infinite plane through the origin of its frame.
struct PlaneShape {
  Vector3 normal = Vector3::UnitZ();
};

/// The triangles of a mesh, a polyline, a heightmap or a cone, which has 48 sides here.
struct TriangleShape {
  /// Vertices; multiplied by `scale` they are in the collision frame.
  std::span<const Vector3> vertices;
  /// Vertex indices, anticlockwise seen from outside unless `scale` mirrors.
  std::span<const std::array<std::uint32_t, 3>> triangles;
  /// Never zero.
  Vector3 scale{1, 1, 1};
  /// Keeps vertices and triangles alive.
  std::shared_ptr<const void> owner = nullptr;
};

/// The file of a mesh.
struct MeshFile {
  /// Absolute path; empty if it was not found.
  std::filesystem::path file;
  /// The submesh to use; empty: the whole file.
  std::string submesh;
  /// Whether the submesh's bounding box is centred on the origin.
  bool isCentered = false;
  /// Along each axis; negative values mirror, zero is not allowed.
  Vector3 scale{1, 1, 1};
};

using Shape = std::variant<NoShape, BoxShape, SphereShape, CylinderShape, CapsuleShape, EllipsoidShape, PlaneShape,
                           TriangleShape>;

}  // namespace pongsim
