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

/// Triangles of a visual with their material: all of a shape, or a part of a mesh.
struct VisiblePart {
  /// A corner of triangles.
  struct Corner {
    Eigen::Vector3f position;
    /// Outwards, of length one.
    Eigen::Vector3f normal;
    /// In the texture: from the left and from the top, 1 being its size.
    Eigen::Vector2f coordinates;
  };
  /// "model::link::visual"; for an actor "actor::visual".
  std::string name;
  Pose X_WorldPart;
  /// Along the axes of the part, before it is turned. Negative: mirrored.
  Vector3 scale = Vector3::Ones();
  std::vector<Corner> corners;
  /// Indices of corners, three for each triangle, counter-clockwise as seen from outside.
  std::vector<std::uint32_t> triangles;
  /// Shares of red, green and blue, as the visual's material says, else that of its file, else grey.
  Eigen::Vector3f ambient, diffuse, specular, emissive;
  /// 1: not to be seen through.
  double opacity = 1;
  /// The picture that goes over it; empty: none.
  std::filesystem::path texture;
};

/// A light that is on.
struct VisibleLight {
  enum class Type { kPoint, kDirectional, kSpot };
  std::string name;
  Type type = Type::kPoint;
  Pose X_WorldLight;
  /// Where it shines, unit vector in the frame of the light; of no meaning for a point.
  Vector3 direction;
  Vector3 diffuse;
  /// At the distance d its light is divided by constant + linear d [1/m] + quadratic d^2 [1/m^2].
  double constantAttenuation = 1;
  double linearAttenuation = 0;
  double quadraticAttenuation = 0;
  /// Of a spot: opening angle of the cone outside of which it is dark [rad], and how fast it gets dark.
  double outerAngle = 0;
  double falloff = 0;
};

/// What is to be seen in a world, as triangles and lights, for who writes it down or draws it by other means.
class PONGSIM_API Appearance {
 public:
  /// Takes in all visuals and lights, where they are now, and reads the files of meshes.
  /// @param diagnostics Warnings about files that can't be read: what they show is left out.
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
