#include "pongsim/appearance.hh"

#include <utility>

#include "rendering/scene.hh"
#include "sim/api/access.hh"

namespace pongsim {

struct Appearance::Content {
  sim::Access& access;
  rendering::Scene scene = {};
};

Appearance::Appearance(const World& world, Diagnostics& diagnostics) : content_(new Content{*world.access_}) {
  content_->scene.build(content_->access.entities, content_->access.state, diagnostics);
}

Appearance::~Appearance() = default;

std::size_t Appearance::partCount() const { return content_->scene.items().size(); }

VisiblePart Appearance::part(std::size_t index) const {
  const rendering::Item& item = content_->scene.items().at(index);
  const world::Entities& entities = content_->access.entities;
  VisiblePart part;
  if (item.actor != nullptr) {
    part.name = item.actor->name + "::" + item.visual;
  } else {
    const world::LinkRecord& link = entities.links()[item.link];
    part.name = entities.models()[link.model].scopedName + "::" + link.description->name + "::" + item.visual;
  }
  part.X_WorldPart = item.X_WorldSurface();
  part.scale = item.scale;
  for (const rendering::Vertex& vertex : item.surface->vertices) {
    part.corners.push_back({vertex.position, vertex.normal, vertex.coordinates});
  }
  part.triangles = item.surface->corners;
  part.ambient = item.paint.ambient;
  part.diffuse = item.paint.diffuse;
  part.specular = item.paint.specular;
  part.emissive = item.paint.emissive;
  part.opacity = static_cast<double>(item.paint.opacity);
  if (item.pictures[rendering::kColorMap] != nullptr) part.texture = item.paint.maps[rendering::kColorMap];
  return part;
}

std::vector<VisibleLight> Appearance::lights() const {
  std::vector<VisibleLight> lights;
  for (const rendering::Lamp& lamp : content_->scene.lamps()) {
    const description::Light& light = lamp.light;
    const auto type = light.type == description::LightType::kPoint         ? VisibleLight::Type::kPoint
                      : light.type == description::LightType::kDirectional ? VisibleLight::Type::kDirectional
                                                                           : VisibleLight::Type::kSpot;
    lights.push_back({light.name, type, lamp.X_WorldLight, light.direction,
                      Eigen::Vector3f(light.diffuse.red, light.diffuse.green, light.diffuse.blue).cast<double>(),
                      light.constantAttenuation, light.linearAttenuation, light.quadraticAttenuation, light.outerAngle,
                      light.falloff});
  }
  return lights;
}

}  // namespace pongsim
