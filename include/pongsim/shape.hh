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

// The shapes of collisions, as values, each in the frame of its collision; lengths in [m].

/// Nothing: an `<empty>`, or a mesh that could not be read.
struct NoShape {};

/// Centred on its frame, with full lengths along x, y, z.
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

/// A cylinder of that length along z with half a ball on each end, centred on its frame.
struct CapsuleShape {
  double radius = 0.5;
  double length = 1;
};

/// Centred on its frame, with radii along x, y, z.
struct EllipsoidShape {
  Vector3 radii{1, 1, 1};
};

/// Through the origin of its frame, without an end.
struct PlaneShape {
  Vector3 normal = Vector3::UnitZ();
};

/// The triangles of a mesh, a polyline or a heightmap.
struct TriangleShape {
  /// Each times `scale` is a point of the collision frame.
  std::span<const Vector3> vertices;
  /// Indices of vertices, anticlockwise seen from outside where no component of `scale` mirrors.
  std::span<const std::array<std::uint32_t, 3>> triangles;
  /// Never zero.
  Vector3 scale{1, 1, 1};
  /// Keeps vertices and triangles.
  std::shared_ptr<const void> owner = nullptr;
};

/// Where the triangles of a mesh are from.
struct MeshFile {
  /// In full; empty where it was not found.
  std::filesystem::path file;
  /// The one part of the file that is meant; empty: all of it.
  std::string submesh;
  /// Whether the part's bounding box is moved to have its centre in the origin.
  bool isCentered = false;
  /// Along each axis; negative mirrors, never zero.
  Vector3 scale{1, 1, 1};
};

using Shape = std::variant<NoShape, BoxShape, SphereShape, CylinderShape, CapsuleShape, EllipsoidShape, PlaneShape,
                           TriangleShape>;

}  // namespace pongsim
