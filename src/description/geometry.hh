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
  bool operator==(const Capsule&) const = default;
};

/// Centred on its frame. Radii along x, y, z [m].
struct Ellipsoid {
  Vector3 radii{1, 1, 1};
  bool operator==(const Ellipsoid&) const = default;
};

/// Through the origin of its frame. As a collision shape it has no end; `size` is that of its picture [m].
struct Plane {
  Vector3 normal = Vector3::UnitZ();
  Eigen::Vector2d size{1, 1};
  bool operator==(const Plane&) const = default;
};

/// `<mesh optimization>`: what collides in place of the triangles.
enum class MeshOptimization {
  /// Where the body moves, convex pieces, as many as the shape asks for.
  kNone,
  kConvexHull,
  kConvexDecomposition,
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
  MeshOptimization optimization = MeshOptimization::kNone;
  /// `<convex_decomposition>`, of effect with that optimization only: how many pieces there may be, 1 to 1000, and how
  /// many voxels the box of the mesh has, below whose edge nothing is looked at.
  std::uint32_t maxConvexHulls = 16;
  std::uint32_t voxelResolution = 200'000;
  /// Before scaling, shared by all that show the same. Null where it could not be read, and for visuals, which are not
  /// read.
  std::shared_ptr<const TriangleMesh> triangles;

  /// @return Whether both show the same part of the same file in the same way.
  bool operator==(const Mesh& other) const {
    return file == other.file && submesh == other.submesh && isCentered == other.isCentered && scale == other.scale &&
           optimization == other.optimization && maxConvexHulls == other.maxConvexHulls &&
           voxelResolution == other.voxelResolution;
  }
};

/// `<texture>` of a heightmap. The first one is at the bottom.
struct HeightmapTexture {
  /// Edge of its picture on the ground [m].
  double size = 10;
  Texture diffuse;
  Texture normal;
  bool operator==(const HeightmapTexture&) const = default;
};

/// `<blend>`: where one texture of a heightmap goes over into the next.
struct HeightmapBlend {
  /// Where it begins [m].
  double minHeight = 0;
  /// How far it takes [m].
  double fadeDistance = 0;
  bool operator==(const HeightmapBlend&) const = default;
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
  /// Points that are drawn a pixel.
  std::uint32_t sampling = 1;
  bool usesPaging = false;
  std::vector<HeightmapTexture> textures;
  std::vector<HeightmapBlend> blends;
  /// With size and position. Null where the image could not be read, and for visuals.
  std::shared_ptr<const TriangleMesh> triangles;

  /// @return Whether both are the same image in the same size and place, and look the same.
  bool operator==(const Heightmap& other) const {
    return file == other.file && size == other.size && position == other.position && sampling == other.sampling &&
           usesPaging == other.usesPaging && textures == other.textures && blends == other.blends;
  }
};

/// `<polyline>`: what closed lines in the xy plane enclose, from z = 0 to `height`. What is within two of them is out
/// again: the inner one is a hole.
struct Polyline {
  /// Each without its first point at its end, three at least.
  std::vector<std::vector<Eigen::Vector2d>> lines;
  /// [m]
  double height = 1;
  /// Null where the lines cross.
  std::shared_ptr<const TriangleMesh> triangles;

  /// @return Whether both enclose the same.
  bool operator==(const Polyline& other) const { return lines == other.lines && height == other.height; }
};

/// `<image>`: boxes on the bright pixels of an image.
struct Image {
  /// As it stands in the description's file.
  std::string uri;
  /// What it names; empty where that is not there.
  std::filesystem::path file;
  /// Edge of a pixel [m].
  double scale = 1;
  /// From this brightness up there is a box, 0 to 255.
  long long threshold = 200;
  /// [m]
  double height = 1;
  /// How many pixels a box may be wrong by.
  long long granularity = 1;
  bool operator==(const Image&) const = default;
};

using Geometry =
    std::variant<Empty, Box, Sphere, Cylinder, Capsule, Ellipsoid, Plane, Mesh, Heightmap, Polyline, Image>;

}  // namespace pongsim::description
