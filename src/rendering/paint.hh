#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>

#include "description/link.hh"
#include "pongsim/types.hh"

namespace pongsim::rendering {

/// Texture maps of a surface: its colour (sRGB), its normals (tangent space: red to the right in the image, green up,
/// blue outward), its roughness and metalness (in red), and its emission (sRGB).
enum Map : std::size_t { kColorMap, kNormalMap, kRoughnessMap, kMetalnessMap, kGlowMap, kMapCount };

/// How a surface reflects light; the part of a `<material>` that is drawn. Colours are linear.
struct Paint {
  Eigen::Vector3f diffuse{0.7F, 0.7F, 0.7F};
  Eigen::Vector3f ambient{0.7F, 0.7F, 0.7F};
  Eigen::Vector3f specular{1, 1, 1};
  Eigen::Vector3f emissive{0, 0, 0};
  float metalness = 0;
  float roughness = 0.6F;
  /// 1: opaque.
  float opacity = 1;
  bool isLit = true;
  bool isDoubleSided = false;
  /// Image files of its textures; empty: none.
  std::array<std::filesystem::path, kMapCount> maps;
};

/// @return The visual's material, else that of the mesh file, else grey.
Paint paintOf(const description::Visual& visual, const std::optional<description::Material>& ofFile);

}  // namespace pongsim::rendering
