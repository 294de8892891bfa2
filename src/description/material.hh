#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "description/color.hh"

namespace pongsim::description {

/// An image file.
struct Texture {
  /// As written in the file; empty: none.
  std::string uri;
  /// The resolved path; empty if the file does not exist.
  std::filesystem::path file;
  bool operator==(const Texture&) const = default;
};

/// What the two workflows of `<pbr>` have in common.
struct PbrMaps {
  Texture albedo;
  Texture normal;
  /// The normal map is in object space instead of tangent space.
  bool areNormalsOfObject = false;
  Texture environment;
  Texture ambientOcclusion;
  Texture emissive;
  Texture light;
  /// Index of the mesh's texture coordinates used for the light map.
  std::uint32_t lightCoordinates = 0;
  bool operator==(const PbrMaps&) const = default;
};

/// `<pbr><metal>`
struct PbrMetal {
  PbrMaps maps;
  /// 0: smooth, 1: rough.
  double roughness = 0.5;
  Texture roughnessMap;
  /// 0: not metallic, 1: metallic.
  double metalness = 0.5;
  Texture metalnessMap;
  bool operator==(const PbrMetal&) const = default;
};

/// `<pbr><specular>`
struct PbrSpecular {
  PbrMaps maps;
  /// 0: rough, 1: smooth.
  double glossiness = 0;
  Texture glossinessMap;
  Texture specularMap;
  bool operator==(const PbrSpecular&) const = default;
};

/// `<material>`: the appearance of a surface.
struct Material {
  Color ambient;
  Color diffuse;
  Color specular;
  Color emissive;
  /// Whether lights affect it.
  bool isLit = true;
  bool isDoubleSided = false;
  /// Of coinciding surfaces, the one with the highest value is visible.
  double renderOrder = 0;
  /// `<script>`: the name of a material, whose colours are set if it is one of Gazebo's own, and its files (not read).
  std::string scriptName;
  std::vector<std::string> scriptUris;
  /// `<shader>`; empty: none.
  std::string shader;
  Texture shaderNormalMap;
  std::optional<PbrMetal> metal;
  std::optional<PbrSpecular> gloss;
  bool operator==(const Material&) const = default;
};

}  // namespace pongsim::description
