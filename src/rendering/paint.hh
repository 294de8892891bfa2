#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>

#include "description/link.hh"
#include "pongsim/types.hh"

namespace pongsim::rendering {

/// What the pictures that go over a surface tell: its colour (sRGB), its normals (of the tangent space: red to the
/// right in the picture, green up, blue outwards), shares of its roughness and metalness (in red), what it emits
/// (sRGB).
enum Map : std::size_t { kColorMap, kNormalMap, kRoughnessMap, kMetalnessMap, kGlowMap, kMapCount };

/// How a surface meets light, of all that a `<material>` may say. Colours are shares of light, linear.
struct Paint {
  Eigen::Vector3f diffuse{0.7F, 0.7F, 0.7F};
  Eigen::Vector3f ambient{0.7F, 0.7F, 0.7F};
  Eigen::Vector3f specular{1, 1, 1};
  Eigen::Vector3f emissive{0, 0, 0};
  float metalness = 0;
  float roughness = 0.6F;
  /// 1: not to be seen through.
  float opacity = 1;
  bool isLit = true;
  bool isDoubleSided = false;
  /// Files of the pictures that go over it; empty: none.
  std::array<std::filesystem::path, kMapCount> maps;
};

/// @return As the visual's material says, else that of its file, else grey.
Paint paintOf(const description::Visual& visual, const std::optional<description::Material>& ofFile);

}  // namespace pongsim::rendering
