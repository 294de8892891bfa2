#include "rendering/scene.hh"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "assets/meshes/ground.hh"
#include "pongsim/geometry/rotation_between.hh"
#include "world/actor_motion.hh"

namespace pongsim::rendering {

namespace {

using world::Slot;

/// How to draw a geometry.
struct Body {
  std::shared_ptr<const Surface> surface = nullptr;
  Pose X_GeometryBody = {};
  Vector3 scale = Vector3::Ones();
  bool isGround = false;
  /// From its file; nothing if the file has none.
  std::optional<description::Material> material = std::nullopt;
};
/// One, or as many as its mesh has parts.
using Bodies = std::vector<Body>;

struct MakeBodies {
  std::map<std::string, std::shared_ptr<const Surface>>& shapes;
  MeshLooks& meshes;
  const Scene::Warn& warn;

  Bodies operator()(const description::Empty&) const { return {}; }
  // as in Fortress
  Bodies operator()(const description::Image&) const { return {}; }
  Bodies operator()(const description::Box& box) const { return {{shape("box", boxSurface), {}, box.size}}; }
  Bodies operator()(const description::Sphere& sphere) const {
    return {{shape("sphere", sphereSurface), {}, Vector3::Constant(sphere.radius)}};
  }
  Bodies operator()(const description::Ellipsoid& ellipsoid) const {
    return {{shape("sphere", sphereSurface), {}, ellipsoid.radii}};
  }
  Bodies operator()(const description::Cylinder& cylinder) const {
    return {{shape("cylinder", cylinderSurface), {}, {cylinder.radius, cylinder.radius, cylinder.length}}};
  }
  Bodies operator()(const description::Cone& cone) const {
    return {{shape("cone", coneSurface), {}, {cone.radius, cone.radius, cone.length}}};
  }
  Bodies operator()(const description::Capsule& capsule) const {
    const std::string name = "capsule " + std::to_string(capsule.radius) + " " + std::to_string(capsule.length);
    return {{shape(name, [&capsule] { return capsuleSurface(capsule); })}};
  }

  // the size of its visual, as in Fortress
  Bodies operator()(const description::Plane& plane) const {
    return {{shape("plane", planeSurface),
             {Vector3::Zero(), rotationBetween(Vector3::UnitZ(), plane.normal)},
             {std::abs(plane.size.x()), std::abs(plane.size.y()), 1},
             true}};
  }

  Bodies operator()(const description::Polyline& polyline) const {
    if (polyline.triangles == nullptr) return {};
    return {{std::make_shared<const Surface>(meshSurface(*polyline.triangles, false))}};
  }

  // the loader has warned about missing files, here and below
  Bodies operator()(const description::Mesh& mesh) const {
    if (mesh.file.empty()) return {};
    const MeshLookKey key(mesh.file, mesh.submesh, mesh.isCentered);
    auto known = meshes.find(key);
    if (known == meshes.end()) known = meshes.emplace(key, read(mesh)).first;
    Bodies bodies;
    for (const MeshPartLook& part : known->second) {
      bodies.push_back({part.surface, {}, mesh.scale, false, part.material});
    }
    return bodies;
  }

  Bodies operator()(const description::Heightmap& heightmap) const {
    if (heightmap.file.empty()) return {};
    const auto ground = assets::readGround(heightmap.file, heightmap.size, heightmap.position);
    if (const auto* problem = std::get_if<assets::Problem>(&ground)) {
      warn("heightmap", heightmap.file, *problem);
      return {};
    }
    if (std::get<0>(ground).triangles.empty()) return {};
    return {{std::make_shared<const Surface>(meshSurface(std::get<0>(ground), true)), {}, Vector3::Ones(), true}};
  }

 private:
  template <class Make>
  std::shared_ptr<const Surface> shape(const std::string& name, const Make& make) const {
    std::shared_ptr<const Surface>& known = shapes[name];
    if (known == nullptr) known = std::make_shared<const Surface>(make());
    return known;
  }

  std::vector<MeshPartLook> read(const description::Mesh& mesh) const {
    auto found = assets::readMeshLook(mesh.file, mesh.submesh, mesh.isCentered);
    if (const auto* problem = std::get_if<assets::Problem>(&found)) {
      warn("mesh", mesh.file, *problem);
      return {};
    }
    std::vector<MeshPartLook> parts;
    for (assets::MeshLook& look : std::get<0>(found)) {
      parts.push_back({std::make_shared<const Surface>(Surface{std::move(look.corners), std::move(look.triangles)}),
                       std::move(look.material)});
    }
    return parts;
  }
};

description::Color plainColor(const Vector3& shares) {
  const Eigen::Vector3f color = shares.cast<float>();
  return {color.x(), color.y(), color.z(), 1};
}

/// @return What is known of a link's visuals: whose they are, and their label unless they have their own.
SeenVisual seenOf(const world::Entities& entities, const world::LinkRecord& link) {
  SeenVisual seen;
  const world::ModelRecord* model = nullptr;
  for (Slot slot = link.model; slot != world::kNoSlot; slot = model->parent) {
    model = &entities.models()[slot];
    if (!seen.label) seen.label = model->description->label;
  }
  seen.owner = model->scopedName;
  return seen;
}

/// @param range Null: none.
/// @return The colour of a particle at a share of its life.
Eigen::Vector4f colorAt(const description::ParticleEmitter& emitter, const assets::Picture* range, double share) {
  const auto vectorOf = [](const description::Color& color) {
    return Eigen::Vector4f(color.red, color.green, color.blue, color.alpha);
  };
  if (range == nullptr || range->width == 0) {
    const auto part = static_cast<float>(share);
    return vectorOf(emitter.colorStart) * (1 - part) + vectorOf(emitter.colorEnd) * part;
  }
  // between two pixels of the first row
  const double place = share * static_cast<double>(range->width - 1);
  const auto left = std::min(static_cast<std::size_t>(place), range->width - 1);
  const std::size_t right = std::min(left + 1, range->width - 1);
  const auto part = static_cast<float>(place - static_cast<double>(left));
  Eigen::Vector4f color;
  for (int i = 0; i < 4; ++i) {
    const auto channel = static_cast<std::size_t>(i);
    color[i] = (static_cast<float>(range->pixels[4 * left + channel]) * (1 - part) +
                static_cast<float>(range->pixels[4 * right + channel]) * part) /
               255;
  }
  return color;
}

bool holds(const world::Entities& entities, Slot outer, Slot model) {
  while (model != outer && model != world::kNoSlot) model = entities.models()[model].parent;
  return model == outer;
}

}  // namespace

Eigen::AlignedBox3d Item::boundsInWorld() const {
  const Pose X = X_WorldSurface();
  const Matrix3 M_WorldSurface = X.rotation.toRotationMatrix() * scale.asDiagonal();
  const Vector3 middle = X.position + M_WorldSurface * bounds.center();
  const Vector3 half = M_WorldSurface.cwiseAbs() * bounds.sizes() / 2;
  return {middle - half, middle + half};
}

void Scene::setColors(const std::optional<Vector3>& background, const std::optional<Vector3>& ambient) {
  background_ = background;
  ambient_ = ambient;
}

void Scene::build(const world::Entities& entities, const world::State& state, Diagnostics& diagnostics) {
  items_.clear();
  limbs_.clear();
  visuals_.clear();
  airTemperature_ = entities.description().environment.atmosphere.temperature;
  ++version_;
  for (Slot slot = 0; slot < entities.links().size(); ++slot) {
    const world::LinkRecord& link = entities.links()[slot];
    if (link.isSetAside) continue;
    Item prototype;
    prototype.link = slot;
    prototype.model = entities.models()[link.model].id;
    const SeenVisual seen = seenOf(entities, link);
    for (std::size_t i = 0; i < link.description->visuals.size(); ++i) {
      const description::Visual& visual = link.description->visuals[i];
      prototype.id = world::visualId(link, i);
      visuals_.push_back(seen);
      addVisual(visual, prototype, "visual '" + visual.name + "' of link '" + link.description->name + "'",
                diagnostics);
    }
    for (const description::ParticleEmitter& emitter : link.description->emitters) {
      picturesOf(emitter,
                 [&](const std::string& kind, const std::filesystem::path& file, const assets::Problem& problem) {
                   std::string text = kind + " '" + file.string() + "' " + problem.text +
                                      ": cameras will not see it on particles of '" + emitter.name + "'";
                   if (said_.insert(text).second) diagnostics.warning(emitter.position, std::move(text), problem.hint);
                 });
    }
  }
  for (const world::ActorRecord& actor : world::present(entities.actors())) addActor(*actor.description, diagnostics);
  surroundings_ = entities.description().scene;
  if (background_) surroundings_.background = plainColor(*background_);
  if (ambient_) surroundings_.ambient = plainColor(*ambient_);
  // capsules of other sizes are other surfaces
  std::erase_if(shapes_, [this](const auto& shape) {
    return std::ranges::none_of(items_, [&shape](const Item& item) { return item.surface == shape.second; });
  });
  update(entities, state);
}

void Scene::addActor(const description::Actor& actor, Diagnostics& diagnostics) {
  Item prototype;
  prototype.actor = &actor;
  const std::size_t before = visuals_.size();
  for (const description::Visual& visual : description::visualsOf(actor)) {
    visuals_.push_back({actor.name, actor.label});
    const std::size_t first = items_.size();
    addVisual(visual, prototype, "visual '" + visual.name + "' of actor '" + actor.name + "'", diagnostics);
    const bool isSkin = !actor.skin.uri.empty() && visuals_.size() == before + 1;
    if (isSkin) addLimbs(actor, first, diagnostics);
  }
}

void Scene::addLimbs(const description::Actor& actor, std::size_t first, Diagnostics& diagnostics) {
  const auto [known, isNew] = figures_.try_emplace(&actor);
  if (isNew) {
    known->second = assets::Figure::load(actor, [&](const std::filesystem::path& file, const assets::Problem& problem) {
      diagnostics.warning(actor.position,
                          "'" + file.string() + "' " + problem.text +
                              ": cameras will not see it move the limbs of actor '" + actor.name + "'",
                          problem.hint);
    });
  }
  if (known->second == nullptr) return;
  for (std::size_t i = first; i < items_.size(); ++i) {
    Limbs limbs{&actor, known->second, i, items_[i].surface, {}, {}};
    for (const Vertex& vertex : limbs.atRest->vertices) {
      limbs.influences.push_back(known->second->influencesAt(vertex.position.cast<double>()));
    }
    limbs_.push_back(std::move(limbs));
  }
}

void Scene::addVisual(const description::Visual& visual, const Item& prototype, const std::string& owner,
                      Diagnostics& diagnostics) {
  const auto warn = [&](const std::string& kind, const std::filesystem::path& file, const assets::Problem& problem) {
    std::string text = kind + " '" + file.string() + "' " + problem.text + ": cameras will not see it on " + owner;
    if (said_.insert(text).second) diagnostics.warning(visual.position, std::move(text), problem.hint);
  };
  if (visual.label) visuals_.back().label = visual.label;
  const std::optional<Warmth> warmth = warmthOf(visual.heat, warn);
  for (const Body& body : std::visit(MakeBodies{shapes_, meshes_, warn}, visual.geometry)) {
    Item item = prototype;
    item.number = visuals_.size() - 1;
    item.warmth = warmth;
    item.surface = body.surface;
    item.visual = visual.name;
    item.paint = paintOf(visual, body.material);
    if (item.paint.opacity <= 0) continue;
    for (std::size_t map = 0; map < kMapCount; ++map) item.pictures[map] = pictureOf(item.paint.maps[map], warn);
    // a map alone sets the emission, as in Fortress
    if (item.pictures[kGlowMap] != nullptr && item.paint.emissive.isZero()) item.paint.emissive.setOnes();
    item.fileDiffuse = item.paint.diffuse;
    item.fileAmbient = item.paint.ambient;
    item.fileSpecular = item.paint.specular;
    item.fileEmissive = item.paint.emissive;
    item.X_LinkSurface = visual.X_LinkVisual * body.X_GeometryBody;
    item.scale = body.scale;
    item.bounds = body.surface->bounds();
    item.visibility = visual.visibilityFlags;
    item.castsShadows = visual.castsShadows;
    item.isGround = body.isGround;
    items_.push_back(std::move(item));
  }
}

std::shared_ptr<const assets::Picture> Scene::pictureOf(const std::filesystem::path& file, const Warn& warn) {
  if (file.empty()) return nullptr;
  const auto [entry, isNew] = pictures_.try_emplace(file);
  if (!isNew) return entry->second;
  auto read = assets::readPicture(file);
  if (const auto* problem = std::get_if<assets::Problem>(&read)) {
    warn("texture", file, *problem);
  } else {
    entry->second = std::make_shared<const assets::Picture>(std::move(std::get<0>(read)));
  }
  return entry->second;
}

std::array<std::shared_ptr<const assets::Picture>, 2> Scene::picturesOf(const description::ParticleEmitter& emitter,
                                                                        const Warn& warn) {
  std::filesystem::path albedo;
  if (emitter.material && emitter.material->metal) albedo = emitter.material->metal->maps.albedo.file;
  if (emitter.material && emitter.material->gloss) albedo = emitter.material->gloss->maps.albedo.file;
  return {pictureOf(albedo, warn), pictureOf(emitter.colorRange.file, warn)};
}

void Scene::place(const world::Particles& particles, const world::Entities& entities, Time time) {
  billboards_.clear();
  for (const world::Emitter& emitter : particles.emitters()) {
    if (emitter.particles.empty() || entities.slot(emitter.link) == world::kNoSlot) continue;
    // `build` has warned of them
    const auto [picture, range] = picturesOf(emitter.now, [](const auto&...) {});
    const description::Color tint =
        emitter.now.material ? emitter.now.material->diffuse : description::Color{1, 1, 1, 1};
    for (const world::Particle& particle : emitter.particles) {
      const world::PlacedParticle placed = world::placed(emitter, particle, time);
      const Eigen::Vector4f color = colorAt(emitter.now, range.get(), placed.share)
                                        .cwiseProduct(Eigen::Vector4f(tint.red, tint.green, tint.blue, tint.alpha));
      billboards_.push_back({placed.place, placed.width / 2, placed.height / 2, color, picture});
    }
  }
}

std::optional<Warmth> Scene::warmthOf(const std::optional<description::Heat>& heat, const Warn& warn) {
  if (!heat) return std::nullopt;
  if (heat->signature.empty()) return Warmth{heat->temperature, heat->temperature, nullptr};
  const double coldest = heat->coldest.value_or(airTemperature_), hottest = heat->hottest.value_or(airTemperature_);
  return Warmth{std::min(coldest, hottest), std::max(coldest, hottest), pictureOf(heat->signature, warn)};
}

void Scene::paint(const std::map<VisualId, VisualColors>& colors) {
  if (colors.empty() && !isPainted_) return;
  isPainted_ = !colors.empty();
  static const VisualColors kNone;
  const auto colorOr = [](const std::optional<Vector3>& color, const Eigen::Vector3f& otherwise) -> Eigen::Vector3f {
    return color ? color->cast<float>() : otherwise;
  };
  for (Item& item : items_) {
    const auto found = colors.find(item.id);
    const VisualColors& told = found == colors.end() ? kNone : found->second;
    item.paint.diffuse = colorOr(told.diffuse, item.fileDiffuse);
    item.paint.ambient = colorOr(told.ambient, colorOr(told.diffuse, item.fileAmbient));
    item.paint.specular = colorOr(told.specular, item.fileSpecular);
    item.paint.emissive = colorOr(told.emissive, item.fileEmissive);
  }
}

void Scene::update(const world::Entities& entities, const world::State& state) {
  for (Item& item : items_) {
    assert(item.actor != nullptr || item.link < state.links.size());
    item.X_WorldLink =
        item.actor != nullptr ? world::actorPose(*item.actor, state) : state.links[item.link].X_WorldLink;
  }
  pose(state);
  time_ = state.time;
  lamps_.clear();
  for (const world::LightRecord& record : world::present(entities.lights())) {
    const description::Light& light = *record.description;
    if (!light.isOn || light.intensity <= 0) continue;
    const Pose X_WorldParent = record.link == world::kNoSlot ? Pose() : state.links[record.link].X_WorldLink;
    lamps_.push_back({light, X_WorldParent * light.X_ParentLight});
  }
  for (const description::Light& light : addedLights_) lamps_.push_back({light, light.X_ParentLight});
}

void Scene::pose(const world::State& state) {
  for (Limbs& limbs : limbs_) {
    assets::Gait gait = world::actorGait(*limbs.actor, state);
    if (gait == limbs.gait) continue;
    const assets::Figure::Bones bones = limbs.figure->bonesIn(gait);
    auto surface = std::make_shared<Surface>(*limbs.atRest);
    for (std::size_t i = 0; i < surface->vertices.size(); ++i) {
      if (limbs.influences[i] == nullptr) continue;
      Vertex& vertex = surface->vertices[i];
      const Eigen::Affine3d move = assets::Figure::blend(*limbs.influences[i], bones);
      vertex.position = (move * vertex.position.cast<double>()).cast<float>();
      vertex.normal = (move.linear() * vertex.normal.cast<double>()).cast<float>().stableNormalized();
    }
    items_[limbs.item].bounds = surface->bounds();
    items_[limbs.item].surface = std::move(surface);
    limbs.gait = std::move(gait);
    // what shows the last gait is not needed any more
    ++version_;
  }
}

Eigen::AlignedBox3d Scene::bounds(const world::Entities& entities, Slot model) const {
  Eigen::AlignedBox3d bodies, ground;
  for (const Item& item : items_) {
    if (model != world::kNoSlot && !holds(entities, model, entities.slot(item.model))) continue;
    (item.isGround ? ground : bodies).extend(item.boundsInWorld());
  }
  return bodies.isEmpty() ? ground : bodies;
}

Eigen::AlignedBox3d Scene::actorBounds(const std::string& name) const {
  Eigen::AlignedBox3d box;
  for (const Item& item : items_) {
    if (item.actor != nullptr && item.actor->name == name) box.extend(item.boundsInWorld());
  }
  return box;
}

}  // namespace pongsim::rendering
