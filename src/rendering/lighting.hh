#pragma once

#include <array>
#include <vector>

#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/types.hh"
#include "rendering/scene.hh"
#include "rendering/shaders.hh"

namespace pongsim::rendering {

/// The lamps of a scene as the shaders have them.
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
};

/// How a scene is lit, as seen from an eye.
struct Lighting {
  LampBlock block;
  /// From places seen from the eye to the clip space of each shadow.
  std::vector<Eigen::Matrix4d> shadows;
};

/// @param shadowEdge Of the pictures that shadows are kept in [pixels].
Lighting lightingOf(const Scene& scene, const PictureView& view, int shadowEdge);

/// @return A colour of a file that is shown as it stands there, as a share of light.
Eigen::Vector3f lightOf(const description::Color& color);

/// Colours of a clear sky straight up and at its edge, as shares of light.
struct SkyColors {
  Eigen::Vector3f zenith;
  Eigen::Vector3f horizon;
};
SkyColors skyColors(const description::Sky& sky);

}  // namespace pongsim::rendering
