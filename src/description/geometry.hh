#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "description/material.hh"
#include "description/triangle_mesh.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// `<empty>`: no shape.
struct Empty {
  bool operator==(const Empty&) const = default;
};

/// Centred on its frame. Full side lengths along x, y, z [m].
struct Box {
  Vector3 size{1, 1, 1};
  bool operator==(const Box&) const = default;
};

/// Centred on its frame [m].
struct Sphere {
  double radius = 1;
  bool operator==(const Sphere&) const = default;
};

/// Centred on its frame, with its axis along z [m].
struct Cylinder {
  double radius = 1;
  double length = 1;
  bool operator==(const Cylinder&) const = default;
};

/// A cylinder of this length along z with a hemisphere on each end [m].
struct Capsule {
  double radius = 0.5;
  double length = 1;
  bool operator==(const Capsule&) const = default;
};

/// Its axis is along z, its tip at half its length above its frame, its base at half below [m].
struct Cone {
  double radius = 1;
  double length = 1;
  bool operator==(const Cone&) const = default;
};

/// Centred on its frame. Radii along x, y, z [m].
struct Ellipsoid {
  Vector3 radii{1, 1, 1};
  bool operator==(const Ellipsoid&) const = default;
};

/// Through the origin of its frame. As a collision shape it is infinite; `size` is that of its visual [m].
struct Plane {
  Vector3 normal = Vector3::UnitZ();
  Eigen::Vector2d size{1, 1};
  bool operator==(const Plane&) const = default;
};

/// `<mesh optimization>`: the collision shape that replaces the triangles.
enum class MeshOptimization {
  /// For moving bodies, convex pieces, as many as the shape needs.
  kNone,
  kConvexHull,
  kConvexDecomposition,
};

/// `<mesh>`: triangles from a file.
struct Mesh {
  /// As written in the file.
  std::string uri;
  /// The resolved path; empty if the file does not exist.
  std::filesystem::path file;
  /// The part of the file to use; empty: all of it.
  std::string submesh;
  /// Whether the centre of the part's bounding box is moved to the origin.
  bool isCentered = false;
  /// Along each axis; negative values mirror; never zero.
  Vector3 scale{1, 1, 1};
  MeshOptimization optimization = MeshOptimization::kNone;
  /// `<convex_decomposition>`, only used with that optimization: the maximum number of pieces, 1 to 1000, and the
  /// number of voxels in the mesh's bounding box, which sets the resolution.
  std::uint32_t maxConvexHulls = 16;
  std::uint32_t voxelResolution = 200'000;
  /// Not scaled, shared by all uses of the same mesh. Null if it can't be read, and for visuals, which are not read.
  std::shared_ptr<const TriangleMesh> triangles;

  /// @return Whether both use the same part of the same file in the same way.
  bool operator==(const Mesh& other) const {
    return file == other.file && submesh == other.submesh && isCentered == other.isCentered && scale == other.scale &&
           optimization == other.optimization && maxConvexHulls == other.maxConvexHulls &&
           voxelResolution == other.voxelResolution;
  }
};

/// `<texture>` of a heightmap. The first one is the lowest.
struct HeightmapTexture {
  /// Edge length of its image on the ground [m].
  double size = 10;
  Texture diffuse;
  Texture normal;
  bool operator==(const HeightmapTexture&) const = default;
};

/// `<blend>`: the transition from one texture of a heightmap to the next.
struct HeightmapBlend {
  /// Height at which it starts [m].
  double minHeight = 0;
  /// Height over which it extends [m].
  double fadeDistance = 0;
  bool operator==(const HeightmapBlend&) const = default;
};

/// `<heightmap>`: terrain whose height is the brightness of an image.
struct Heightmap {
  /// As written in the file.
  std::string uri;
  /// The resolved path; empty if the file does not exist.
  std::filesystem::path file;
  /// Total size; z is from black to the brightest pixel of the image [m].
  Vector3 size{1, 1, 1};
  /// Position of its centre, at the height of black [m].
  Vector3 position = Vector3::Zero();
  /// Points drawn for each pixel.
  std::uint32_t sampling = 1;
  bool usesPaging = false;
  std::vector<HeightmapTexture> textures;
  std::vector<HeightmapBlend> blends;
  /// With size and position applied. Null if the image can't be read, and for visuals.
  std::shared_ptr<const TriangleMesh> triangles;

  /// @return Whether both use the same image with the same size, position and appearance.
  bool operator==(const Heightmap& other) const {
    return file == other.file && size == other.size && position == other.position && sampling == other.sampling &&
           usesPaging == other.usesPaging && textures == other.textures && blends == other.blends;
  }
};

/// `<polyline>`: closed lines in the xy plane, extruded from z = 0 to `height`. Where two lines are nested, the inner
/// one is a hole.
struct Polyline {
  /// Each with at least three points; the first point is not repeated at the end.
  std::vector<std::vector<Eigen::Vector2d>> lines;
  /// [m]
  double height = 1;
  /// Null if the lines cross.
  std::shared_ptr<const TriangleMesh> triangles;

  /// @return Whether both enclose the same volume.
  bool operator==(const Polyline& other) const { return lines == other.lines && height == other.height; }
};

/// `<image>`: boxes on the bright pixels of an image.
struct Image {
  /// As written in the file.
  std::string uri;
  /// The resolved path; empty if the file does not exist.
  std::filesystem::path file;
  /// Edge length of a pixel [m].
  double scale = 1;
  /// Minimum brightness of a pixel that gets a box, 0 to 255.
  long long threshold = 200;
  /// [m]
  double height = 1;
  /// By how many pixels a box may be off.
  long long granularity = 1;
  bool operator==(const Image&) const = default;
};

using Geometry =
    std::variant<Empty, Box, Sphere, Cylinder, Capsule, Ellipsoid, Plane, Mesh, Heightmap, Polyline, Image, Cone>;

}  // namespace pongsim::description
