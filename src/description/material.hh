#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "description/color.hh"

namespace pongsim::description {

/// The file of a picture.
struct Texture {
  /// As it stands in the description's file; empty: none is named.
  std::string uri;
  /// What it names; empty where that is not there.
  std::filesystem::path file;
  bool operator==(const Texture&) const = default;
};

/// What the two ways of `<pbr>` have in common.
struct PbrMaps {
  Texture albedo;
  Texture normal;
  /// The normals are in the object's space, in place of that of the surface.
  bool areNormalsOfObject = false;
  Texture environment;
  Texture ambientOcclusion;
  Texture emissive;
  Texture light;
  /// Which of the mesh's texture coordinates the light map goes by.
  std::uint32_t lightCoordinates = 0;
  bool operator==(const PbrMaps&) const = default;
};

/// `<pbr><metal>`
struct PbrMetal {
  PbrMaps maps;
  /// 0: smooth, 1: rough.
  double roughness = 0.5;
  Texture roughnessMap;
  /// 0: no metal, 1: metal.
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

/// `<material>`: how a surface looks.
struct Material {
  Color ambient;
  Color diffuse;
  Color specular;
  Color emissive;
  /// Lights change how it looks.
  bool isLit = true;
  bool isDoubleSided = false;
  /// Of surfaces in one place the one with the highest is seen.
  double renderOrder = 0;
  /// `<script>`: the name of a material in one of these files, which Ogre reads and pongsim does not.
  std::string scriptName;
  std::vector<std::string> scriptUris;
  /// `<shader>`: empty: none is named.
  std::string shader;
  Texture shaderNormalMap;
  std::optional<PbrMetal> metal;
  std::optional<PbrSpecular> gloss;
  bool operator==(const Material&) const = default;
};

}  // namespace pongsim::description
