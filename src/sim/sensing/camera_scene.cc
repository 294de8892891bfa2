#include "pongsim/sensing/camera_scene.hh"

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "assets/images/picture_file.hh"
#include "rendering/boxes.hh"
#include "rendering/renderer.hh"
#include "rendering/renderer_choice.hh"
#include "rendering/scene.hh"
#include "sim/api/access.hh"
#include "sim/sensing/scatter.hh"

namespace pongsim {

struct CameraScene::Content {
  sim::Access& access;
  std::unique_ptr<rendering::Renderer> renderer;
  rendering::Scene scene = {};
  /// `Access::changes` at the last `rebuild`.
  std::uint64_t changes = 0;
  MarkerViewers viewers = MarkerViewers::kSensors;

  rendering::MarkerList markers() const {
    const bool isSensor = viewers == MarkerViewers::kSensors;
    rendering::MarkerList list;
    for (const auto& [key, marker] : (isSensor ? access.sensorMarkers : access.peopleMarkers).all()) {
      list.push_back(marker);
    }
    for (const auto& [key, marker] : (isSensor ? access.peopleMarkers : access.sensorMarkers).all()) {
      if (marker->isForAll) list.push_back(marker);
    }
    return list;
  }
};

CameraScene::CameraScene(const World& world)
    : content_(new Content{*world.access_, std::make_unique<rendering::Renderer>(rendering::openContexts())}) {}

CameraScene::~CameraScene() = default;

void CameraScene::setColors(const std::optional<Vector3>& background, const std::optional<Vector3>& ambient) {
  content_->scene.setColors(background, ambient);
}

void CameraScene::addLight(const VisibleLight& light) {
  using enum description::LightType;
  description::Light added;
  added.name = light.name;
  added.type = light.type == VisibleLight::Type::kPoint  ? kPoint
               : light.type == VisibleLight::Type::kSpot ? kSpot
                                                         : kDirectional;
  added.X_ParentLight = light.X_WorldLight;
  if (light.type != VisibleLight::Type::kPoint) added.direction = light.direction;
  added.diffuse = {static_cast<float>(light.diffuse.x()), static_cast<float>(light.diffuse.y()),
                   static_cast<float>(light.diffuse.z()), 1};
  added.range = std::numeric_limits<double>::infinity();
  added.constantAttenuation = light.constantAttenuation;
  added.linearAttenuation = light.linearAttenuation;
  added.quadraticAttenuation = light.quadraticAttenuation;
  added.outerAngle = light.outerAngle;
  added.falloff = light.falloff;
  content_->scene.addLight(added);
}

void CameraScene::setMarkerViewers(MarkerViewers viewers) { content_->viewers = viewers; }

void CameraScene::rebuild(Diagnostics& diagnostics) {
  content_->changes = content_->access.changes;
  content_->scene.build(content_->access.entities, content_->access.state, diagnostics);
}

void CameraScene::update() {
  // levels load and unload within a step, and a program that steps the simulation is not notified of that
  if (content_->changes != content_->access.changes) {
    Diagnostics none;
    rebuild(none);
  }
  content_->scene.update(content_->access.entities, content_->access.state);
  content_->scene.paint(content_->access.colors);
  content_->scene.place(content_->access.particlesNow(), content_->access.entities, content_->access.state.time);
  content_->scene.show(content_->markers(), content_->access.entities, content_->access.state);
}

void CameraScene::drawColors(const PictureView& view, std::span<std::uint8_t> pixels) {
  content_->renderer->drawColors(content_->scene, view, pixels);
}

void CameraScene::drawDepths(const PictureView& view, std::span<float> depths) {
  content_->renderer->drawDepths(content_->scene, view, depths);
}

void CameraScene::scatterDepths(const PictureView& view, std::string_view camera, std::span<float> depths) {
  if (content_->access.particlesNow().emitters().empty()) return;
  sim::Scatter scatter(content_->access, camera);
  if (scatter.isAnything()) scatter.apply(view, depths);
}

const std::vector<SeenVisual>& CameraScene::visuals() const { return content_->scene.visuals(); }

void CameraScene::drawNumbers(const PictureView& view, std::span<std::uint32_t> numbers) {
  content_->renderer->drawNumbers(content_->scene, view, numbers);
}

void CameraScene::drawTemperatures(const PictureView& view, std::span<float> temperatures) {
  const description::Atmosphere& air = content_->access.entities.description().environment.atmosphere;
  content_->renderer->drawTemperatures(content_->scene, view, rendering::airTemperatures(air, view), temperatures);
}

Eigen::AlignedBox2d CameraScene::imageBounds(std::size_t visual, const PictureView& view) const {
  return rendering::imageBounds(content_->scene, visual, view);
}

TurnedBox CameraScene::turnedBox(std::span<const std::size_t> visuals) const {
  return rendering::turnedBox(content_->scene, visuals);
}

void CameraScene::writePicture(const std::filesystem::path& file, std::uint32_t width, std::uint32_t height,
                               std::span<const std::uint8_t> pixels) {
  if (const auto problem = assets::writePicture(file, width, height, pixels)) {
    throw std::runtime_error("'" + file.string() + "' " + problem->text);
  }
}

Eigen::AlignedBox3d CameraScene::bounds(const std::optional<Model>& model) const {
  const world::Slot slot = model ? sim::slotOf(content_->access, model->id()) : world::kNoSlot;
  return content_->scene.bounds(content_->access.entities, slot);
}

std::vector<std::string> CameraScene::actors() const {
  std::vector<std::string> names;
  for (const world::ActorRecord& actor : world::present(content_->access.entities.actors())) {
    names.push_back(actor.description->name);
  }
  return names;
}

Eigen::AlignedBox3d CameraScene::actorBounds(const std::string& name) const {
  return content_->scene.actorBounds(name);
}

}  // namespace pongsim
