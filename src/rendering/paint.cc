#include "rendering/paint.hh"

#include <algorithm>

namespace pongsim::rendering {

namespace {

using description::Color;
using description::Material;

Eigen::Vector3f vectorOf(const Color& color) { return {color.red, color.green, color.blue}; }

float share(double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); }

void takeMaps(const description::PbrMaps& maps, Paint& paint) {
  paint.maps[kColorMap] = maps.albedo.file;
  // object-space normals are treated as tangent-space ones, as in Fortress
  paint.maps[kNormalMap] = maps.normal.file;
  paint.maps[kGlowMap] = maps.emissive.file;
}

Paint paintOf(const Material& material) {
  Paint paint;
  paint.diffuse = vectorOf(material.diffuse);
  // most materials set both to the same colour; those that leave out the second are no darker in Fortress
  paint.ambient = material.ambient == Color() ? paint.diffuse : vectorOf(material.ambient);
  paint.specular = vectorOf(material.specular);
  paint.emissive = vectorOf(material.emissive);
  paint.opacity = share(material.diffuse.alpha);
  paint.isLit = material.isLit;
  paint.isDoubleSided = material.isDoubleSided;
  if (material.metal) {
    takeMaps(material.metal->maps, paint);
    paint.maps[kRoughnessMap] = material.metal->roughnessMap.file;
    paint.maps[kMetalnessMap] = material.metal->metalnessMap.file;
    paint.metalness = share(material.metal->metalness);
    paint.roughness = share(material.metal->roughness);
  } else if (material.gloss) {
    takeMaps(material.gloss->maps, paint);
    paint.roughness = share(1 - material.gloss->glossiness);
  }
  return paint;
}

}  // namespace

Paint paintOf(const description::Visual& visual, const std::optional<Material>& ofFile) {
  Paint paint = visual.material ? paintOf(*visual.material) : ofFile ? paintOf(*ofFile) : Paint();
  paint.opacity *= share(1 - visual.transparency);
  return paint;
}

}  // namespace pongsim::rendering
