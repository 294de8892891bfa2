#include "msgs/scene/material_message.hh"

#include <ignition/msgs/material.pb.h>

#include <string>

#include "msgs/scene/color_message.hh"
#include "msgs/scene/full_path.hh"

namespace pongsim::msgs {

namespace {

namespace im = ignition::msgs;

void setMaps(const description::PbrMaps& maps, im::Material::PBR& message) {
  message.set_albedo_map(pathOf(maps.albedo));
  message.set_normal_map(pathOf(maps.normal));
  message.set_environment_map(pathOf(maps.environment));
  message.set_ambient_occlusion_map(pathOf(maps.ambientOcclusion));
  message.set_emissive_map(pathOf(maps.emissive));
  message.set_light_map(pathOf(maps.light));
  message.set_light_map_texcoord_set(maps.lightCoordinates);
}

description::PbrMaps mapsFrom(const im::Material::PBR& message) {
  description::PbrMaps maps;
  maps.albedo.uri = message.albedo_map();
  maps.normal.uri = message.normal_map();
  maps.environment.uri = message.environment_map();
  maps.ambientOcclusion.uri = message.ambient_occlusion_map();
  maps.emissive.uri = message.emissive_map();
  maps.light.uri = message.light_map();
  maps.lightCoordinates = message.light_map_texcoord_set();
  return maps;
}

}  // namespace

description::Material materialFrom(const im::Material& message) {
  description::Material material;
  material.ambient = colorOf(message.ambient());
  material.diffuse = colorOf(message.diffuse());
  material.specular = colorOf(message.specular());
  material.emissive = colorOf(message.emissive());
  material.isLit = message.lighting();
  material.isDoubleSided = message.double_sided();
  material.renderOrder = message.render_order();
  if (!message.has_pbr()) return material;
  const im::Material::PBR& pbr = message.pbr();
  if (pbr.type() == im::Material::PBR::METAL) {
    material.metal = {
        mapsFrom(pbr), pbr.roughness(), {pbr.roughness_map(), {}}, pbr.metalness(), {pbr.metalness_map(), {}}};
  } else if (pbr.type() == im::Material::PBR::SPECULAR) {
    material.gloss = {mapsFrom(pbr), pbr.glossiness(), {pbr.glossiness_map(), {}}, {pbr.specular_map(), {}}};
  }
  return material;
}

void setMaterial(const description::Material& material, im::Material& message) {
  message.Clear();
  setColor(material.ambient, *message.mutable_ambient());
  setColor(material.diffuse, *message.mutable_diffuse());
  setColor(material.specular, *message.mutable_specular());
  setColor(material.emissive, *message.mutable_emissive());
  message.set_lighting(material.isLit);
  message.set_double_sided(material.isDoubleSided);
  message.set_render_order(material.renderOrder);
  // Fortress prefers this one of the two
  if (material.metal) {
    im::Material::PBR& pbr = *message.mutable_pbr();
    pbr.set_type(im::Material::PBR::METAL);
    setMaps(material.metal->maps, pbr);
    pbr.set_metalness(material.metal->metalness);
    pbr.set_metalness_map(pathOf(material.metal->metalnessMap));
    pbr.set_roughness(material.metal->roughness);
    pbr.set_roughness_map(pathOf(material.metal->roughnessMap));
  } else if (material.gloss) {
    im::Material::PBR& pbr = *message.mutable_pbr();
    pbr.set_type(im::Material::PBR::SPECULAR);
    setMaps(material.gloss->maps, pbr);
    pbr.set_glossiness(material.gloss->glossiness);
    pbr.set_glossiness_map(pathOf(material.gloss->glossinessMap));
    pbr.set_specular_map(pathOf(material.gloss->specularMap));
  }
}

}  // namespace pongsim::msgs
