#include "sdf/readers/shapes/material_reader.hh"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "sdf/includes/asset_file.hh"
#include "sdf/readers/shapes/gazebo_material.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

description::PbrMaps readMaps(const Element& element, Context& context) {
  constexpr std::array<std::string_view, 2> kSpaces{"tangent", "object"};
  description::PbrMaps maps;
  maps.albedo = readTexture(element, "albedo_map", context);
  maps.normal = readTexture(element, "normal_map", context);
  if (const Element* normal = element.child("normal_map")) {
    maps.areNormalsOfObject = readWordAttribute(*normal, "type", 0, kSpaces, context) == 1;
  }
  maps.environment = readTexture(element, "environment_map", context);
  maps.ambientOcclusion = readTexture(element, "ambient_occlusion_map", context);
  maps.emissive = readTexture(element, "emissive_map", context);
  maps.light = readTexture(element, "light_map", context);
  if (const Element* light = element.child("light_map")) {
    maps.lightCoordinates = static_cast<std::uint32_t>(
        readIntegerAttribute(*light, "uv_set", 0, 0, std::numeric_limits<std::uint32_t>::max(), context));
  }
  return maps;
}

description::PbrMetal readMetal(const Element& element, Context& context) {
  description::PbrMetal metal;
  metal.maps = readMaps(element, context);
  metal.roughness = readNumber(element, "roughness", metal.roughness, context);
  metal.roughnessMap = readTexture(element, "roughness_map", context);
  metal.metalness = readNumber(element, "metalness", metal.metalness, context);
  metal.metalnessMap = readTexture(element, "metalness_map", context);
  return metal;
}

description::PbrSpecular readSpecular(const Element& element, Context& context) {
  description::PbrSpecular specular;
  specular.maps = readMaps(element, context);
  specular.glossiness = readNumber(element, "glossiness", specular.glossiness, context);
  specular.glossinessMap = readTexture(element, "glossiness_map", context);
  specular.specularMap = readTexture(element, "specular_map", context);
  return specular;
}

}  // namespace

description::Material readMaterial(const Element& element, Context& context) {
  description::Material material;
  if (const Element* script = element.child("script")) {
    const std::string name = readText(*script, "name", "");
    // its colours are those that the material has none of its own for
    if (const description::Material* named = gazeboMaterial(name)) material = *named;
    material.scriptName = name;
    for (const Element* uri : script->childrenNamed("uri")) material.scriptUris.push_back(uri->text);
  }
  material.ambient = readColor(element, "ambient", material.ambient, context);
  material.diffuse = readColor(element, "diffuse", material.diffuse, context);
  material.specular = readColor(element, "specular", material.specular, context);
  material.emissive = readColor(element, "emissive", material.emissive, context);
  material.isLit = readFlag(element, "lighting", material.isLit, context);
  material.isDoubleSided = readFlag(element, "double_sided", material.isDoubleSided, context);
  material.renderOrder = readNumber(element, "render_order", material.renderOrder, context);
  if (const Element* shader = element.child("shader")) {
    constexpr std::array<std::string_view, 4> kShaders{"pixel", "vertex", "normal_map_object_space",
                                                       "normal_map_tangent_space"};
    material.shader = kShaders[readWordAttribute(*shader, "type", 0, kShaders, context)];
    material.shaderNormalMap = readTexture(*shader, "normal_map", context);
  }
  const Element* pbr = element.child("pbr");
  if (pbr == nullptr) return material;
  if (const Element* metal = pbr->child("metal")) material.metal = readMetal(*metal, context);
  if (const Element* specular = pbr->child("specular")) material.gloss = readSpecular(*specular, context);
  return material;
}

}  // namespace pongsim::sdf
