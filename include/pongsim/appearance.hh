#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Triangles of a visual and their material: a whole shape, or a part of a mesh.
struct VisiblePart {
  /// A vertex.
  struct Corner {
    Eigen::Vector3f position;
    /// Outward unit vector.
    Eigen::Vector3f normal;
    /// Texture coordinates, from the left and from the top; 1 is the full size.
    Eigen::Vector2f coordinates;
  };
  /// "model::link::visual"; for an actor "actor::visual".
  std::string name;
  Pose X_WorldPart;
  /// Along the axes of the part, before rotation. Negative values mirror.
  Vector3 scale = Vector3::Ones();
  std::vector<Corner> corners;
  /// Vertex indices, three for each triangle, counter-clockwise seen from outside.
  std::vector<std::uint32_t> triangles;
  /// Red, green and blue, 0 to 1: from the visual's material, else from the mesh file, else grey.
  Eigen::Vector3f ambient, diffuse, specular, emissive;
  /// 1: opaque.
  double opacity = 1;
  /// Image file of the texture; empty: none.
  std::filesystem::path texture;
};

/// A light that is switched on.
struct VisibleLight {
  enum class Type { kPoint, kDirectional, kSpot };
  std::string name;
  Type type = Type::kPoint;
  Pose X_WorldLight;
  /// Direction of the light, unit vector in the frame of the light; unused for point lights.
  Vector3 direction;
  Vector3 diffuse;
  /// At distance d the light is divided by constant + linear d [1/m] + quadratic d^2 [1/m^2].
  double constantAttenuation = 1;
  double linearAttenuation = 0;
  double quadraticAttenuation = 0;
  /// For spot lights: full angle of the cone outside of which it is dark [rad], and how fast the light falls off.
  double outerAngle = 0;
  double falloff = 0;
};

/// The visible parts of a world as triangles and lights, for exporting or drawing it.
class PONGSIM_API Appearance {
 public:
  /// Collects all visuals and lights at their current poses, and reads mesh files.
  /// @param diagnostics Warnings about files that can't be read; their visuals are left out.
  Appearance(const World& world, Diagnostics& diagnostics);
  ~Appearance();

  std::size_t partCount() const;
  VisiblePart part(std::size_t index) const;
  std::vector<VisibleLight> lights() const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim
