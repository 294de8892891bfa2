#include "rendering/paint.hh"

#include <algorithm>

namespace pongsim::rendering {

namespace {

using description::Color;
using description::Material;

Eigen::Vector3f vectorOf(const Color& color) { return {color.red, color.green, color.blue}; }

float share(double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); }

Paint paintOf(const Material& material) {
  Paint paint;
  paint.diffuse = vectorOf(material.diffuse);
  // most materials give the same colour twice; those that leave the second out are no darker for that in Fortress
  paint.ambient = material.ambient == Color() ? paint.diffuse : vectorOf(material.ambient);
  paint.specular = vectorOf(material.specular);
  paint.emissive = vectorOf(material.emissive);
  paint.opacity = share(material.diffuse.alpha);
  paint.isLit = material.isLit;
  paint.isDoubleSided = material.isDoubleSided;
  if (material.metal) {
    paint.texture = material.metal->maps.albedo.file;
    paint.metalness = share(material.metal->metalness);
    paint.roughness = share(material.metal->roughness);
  } else if (material.gloss) {
    paint.texture = material.gloss->maps.albedo.file;
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
