#include "rendering/scene.hh"

#include <cmath>
#include <utility>
#include <variant>

#include "assets/ground.hh"

namespace pongsim::rendering {

namespace {

using description::TriangleMesh;
using world::Slot;

/// What a geometry looks like.
struct Body {
  /// Null: it is not drawn.
  std::shared_ptr<const Surface> surface = nullptr;
  Pose X_GeometryBody = {};
  Vector3 scale = Vector3::Ones();
  bool isGround = false;
};

struct MakeBody {
  assets::MeshStore& meshes;
  std::map<std::string, std::shared_ptr<const Surface>>& shapes;
  std::map<std::shared_ptr<const TriangleMesh>, std::shared_ptr<const Surface>>& surfaces;
  const Scene::Warn& warn;

  Body operator()(const description::Empty&) const { return {}; }
  // as in Fortress
  Body operator()(const description::Image&) const { return {}; }
  Body operator()(const description::Box& box) const { return {shape("box", boxSurface), {}, box.size}; }
  Body operator()(const description::Sphere& sphere) const {
    return {shape("sphere", sphereSurface), {}, Vector3::Constant(sphere.radius)};
  }
  Body operator()(const description::Ellipsoid& ellipsoid) const {
    return {shape("sphere", sphereSurface), {}, ellipsoid.radii};
  }
  Body operator()(const description::Cylinder& cylinder) const {
    return {shape("cylinder", cylinderSurface), {}, {cylinder.radius, cylinder.radius, cylinder.length}};
  }
  Body operator()(const description::Capsule& capsule) const {
    const std::string name = "capsule " + std::to_string(capsule.radius) + " " + std::to_string(capsule.length);
    return {shape(name, [&capsule] { return capsuleSurface(capsule); })};
  }

  // as large as its picture, as in Fortress
  Body operator()(const description::Plane& plane) const {
    return {shape("plane", planeSurface),
            {Vector3::Zero(), Quaternion::FromTwoVectors(Vector3::UnitZ(), plane.normal)},
            {std::abs(plane.size.x()), std::abs(plane.size.y()), 1},
            true};
  }

  Body operator()(const description::Polyline& polyline) const {
    if (polyline.triangles == nullptr) return {};
    return {surfaceOf(polyline.triangles, false)};
  }

  // of a file that is not there, here and below, the loader has warned
  Body operator()(const description::Mesh& mesh) const {
    if (mesh.file.empty()) return {};
    const assets::MeshStore::Found found = meshes.find(mesh.file, mesh.submesh, mesh.isCentered);
    if (const auto* problem = std::get_if<assets::Problem>(&found)) {
      warn("mesh", mesh.file, *problem);
      return {};
    }
    return {surfaceOf(std::get<0>(found), false), {}, mesh.scale};
  }

  Body operator()(const description::Heightmap& heightmap) const {
    if (heightmap.file.empty()) return {};
    const auto ground = assets::readGround(heightmap.file, heightmap.size, heightmap.position);
    if (const auto* problem = std::get_if<assets::Problem>(&ground)) {
      warn("heightmap", heightmap.file, *problem);
      return {};
    }
    if (std::get<0>(ground).triangles.empty()) return {};
    return {std::make_shared<const Surface>(meshSurface(std::get<0>(ground), true)), {}, Vector3::Ones(), true};
  }

 private:
  template <class Make>
  std::shared_ptr<const Surface> shape(const std::string& name, const Make& make) const {
    std::shared_ptr<const Surface>& known = shapes[name];
    if (known == nullptr) known = std::make_shared<const Surface>(make());
    return known;
  }

  std::shared_ptr<const Surface> surfaceOf(const std::shared_ptr<const TriangleMesh>& mesh, bool isSmooth) const {
    std::shared_ptr<const Surface>& known = surfaces[mesh];
    if (known == nullptr) known = std::make_shared<const Surface>(meshSurface(*mesh, isSmooth));
    return known;
  }
};

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

void Scene::build(const world::Entities& entities, const world::State& state, Diagnostics& diagnostics) {
  items_.clear();
  ++version_;
  for (Slot slot = 0; slot < entities.links().size(); ++slot) {
    const world::LinkRecord& link = entities.links()[slot];
    Item prototype;
    prototype.link = slot;
    prototype.model = entities.models()[link.model].id;
    for (const description::Visual& visual : link.description->visuals) {
      addVisual(visual, prototype, "visual '" + visual.name + "' of link '" + link.description->name + "'",
                diagnostics);
    }
  }
  surroundings_ = entities.description().scene;
  update(entities, state);
}

void Scene::addVisual(const description::Visual& visual, const Item& prototype, const std::string& owner,
                      Diagnostics& diagnostics) {
  const auto warn = [&](const std::string& kind, const std::filesystem::path& file, const assets::Problem& problem) {
    std::string text = kind + " '" + file.string() + "' " + problem.text + ": cameras will not see it on " + owner;
    if (said_.insert(text).second) diagnostics.warning(visual.position, std::move(text), problem.hint);
  };
  const Body body = std::visit(MakeBody{meshes_, shapes_, surfaces_, warn}, visual.geometry);
  if (body.surface == nullptr) return;
  Item item = prototype;
  item.surface = body.surface;
  item.paint = paintOf(visual, Paint());
  if (item.paint.opacity <= 0) return;
  item.picture = pictureOf(item.paint.texture, warn);
  item.X_LinkSurface = visual.X_LinkVisual * body.X_GeometryBody;
  item.scale = body.scale;
  item.bounds = body.surface->bounds();
  item.visibility = visual.visibilityFlags;
  item.castsShadows = visual.castsShadows;
  item.isGround = body.isGround;
  items_.push_back(std::move(item));
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

void Scene::update(const world::Entities& entities, const world::State& state) {
  for (Item& item : items_) item.X_WorldLink = state.links[item.link].X_WorldLink;
  lamps_.clear();
  for (const world::LightRecord& record : entities.lights()) {
    const description::Light& light = *record.description;
    if (!light.isOn || light.intensity <= 0) continue;
    const Pose X_WorldParent = record.link == world::kNoSlot ? Pose() : state.links[record.link].X_WorldLink;
    lamps_.push_back({&light, X_WorldParent * light.X_ParentLight});
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

}  // namespace pongsim::rendering
