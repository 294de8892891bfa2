#pragma once

#include <filesystem>
#include <optional>

#include "description/link.hh"
#include "pongsim/types.hh"

namespace pongsim::rendering {

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
  /// Picture that goes over it; empty: none.
  std::filesystem::path texture;
};

/// @return As the visual's material says, else that of its file, else grey.
Paint paintOf(const description::Visual& visual, const std::optional<description::Material>& ofFile);

}  // namespace pongsim::rendering
