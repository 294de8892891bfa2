#pragma once

#include <array>
#include <compare>
#include <vector>

#include "description/scene.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/types.hh"
#include "rendering/scene.hh"
#include "rendering/shaders.hh"

namespace pongsim::rendering {

/// The lights of a scene, laid out for the shaders.
struct LampBlock {
  struct Lamp {
    Eigen::Vector4f place;
    Eigen::Vector4f direction;
    Eigen::Vector4f diffuse;
    Eigen::Vector4f specular;
    Eigen::Vector4f attenuation;
    Eigen::Vector4f cone;
  };
  std::array<Lamp, shaders::kMostLamps> lamps;
  std::array<Eigen::Matrix4f, shaders::kMostShadows> shadowFromPlace;
  Eigen::Vector4f surroundings;
  Eigen::Vector4f background;
  Eigen::Vector4f fog;
  Eigen::Vector4f fogPlace;
};

/// What a program must know of a lamp when it is compiled.
struct LampKind {
  /// If false, its light comes from all over the sky.
  bool hasPlace = false;
  bool isSpot = false;
  /// Number of its shadow, or -1.
  int shadow = -1;

  auto operator<=>(const LampKind&) const = default;
};

/// What a lamp sees. It depends on the camera only in scenes that are larger than their shadows.
struct Shadow {
  /// World frame.
  Vector3 origin;
  /// From positions relative to the origin to the shadow map's clip space.
  Eigen::Matrix4d clip;

  bool operator==(const Shadow&) const = default;
};

/// What a program must know of the lamps in the block, and of the air, when it is compiled.
struct LightKinds {
  std::vector<LampKind> lamps;
  description::Fog::Type fog = description::Fog::Type::kNone;

  auto operator<=>(const LightKinds&) const = default;
};

/// How a scene is lit, seen from a camera.
struct Lighting {
  LampBlock block;
  LightKinds kinds;
  std::vector<Shadow> shadows;
};

/// @param shadowEdge Edge length of the shadow maps [pixels].
Lighting lightingOf(const Scene& scene, const PictureView& view, int shadowEdge);

/// @return A colour from a file as linear light.
Eigen::Vector3f lightOf(const description::Color& color);

/// Colours of a clear sky at the zenith and at the horizon, and of its clouds, as linear light.
struct SkyColors {
  Eigen::Vector3f zenith;
  Eigen::Vector3f horizon;
  Eigen::Vector3f clouds;
};
SkyColors skyColors(const description::Sky& sky);

/// The clouds for the shader: how far they have moved and cells per unit, in heights of the clouds, and their humidity.
Eigen::Vector4f cloudsOf(const description::Sky& sky, Time time);

}  // namespace pongsim::rendering
