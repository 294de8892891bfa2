#include <cmath>
#include <memory>

#include "description/cone_triangles.hh"
#include "pongsim/sensing/sensor.hh"
#include "sim/api/access.hh"

namespace pongsim {

namespace {

using sim::slotOf;

const world::CollisionRecord& record(const sim::Access& access, CollisionId id) {
  return access.entities.collisions()[slotOf(access, id)];
}

/// @return The collision's index among those of its link.
std::size_t numberInLink(const sim::Access& access, CollisionId id) {
  const world::Slot slot = slotOf(access, id);
  return slot - access.entities.links()[access.entities.collisions()[slot].link].firstCollision;
}

Shape trianglesOf(const std::shared_ptr<const description::TriangleMesh>& mesh, const Vector3& scale) {
  if (mesh == nullptr) return NoShape();
  return TriangleShape{mesh->vertices, mesh->triangles, scale, mesh};
}

struct ShapeOf {
  Shape operator()(const description::Box& box) const { return BoxShape{box.size}; }
  Shape operator()(const description::Sphere& sphere) const { return SphereShape{sphere.radius}; }
  Shape operator()(const description::Cylinder& shape) const { return CylinderShape{shape.radius, shape.length}; }
  Shape operator()(const description::Capsule& shape) const { return CapsuleShape{shape.radius, shape.length}; }
  Shape operator()(const description::Ellipsoid& ellipsoid) const { return EllipsoidShape{ellipsoid.radii}; }
  Shape operator()(const description::Cone& cone) const {
    return trianglesOf(std::make_shared<const description::TriangleMesh>(description::coneTriangles(cone)), {1, 1, 1});
  }
  Shape operator()(const description::Plane& plane) const { return PlaneShape{plane.normal.normalized()}; }
  Shape operator()(const description::Mesh& mesh) const { return trianglesOf(mesh.triangles, mesh.scale); }
  Shape operator()(const description::Heightmap& map) const { return trianglesOf(map.triangles, {1, 1, 1}); }
  Shape operator()(const description::Polyline& line) const { return trianglesOf(line.triangles, {1, 1, 1}); }
  Shape operator()(const description::Empty&) const { return NoShape(); }
  Shape operator()(const description::Image&) const { return NoShape(); }
};

}  // namespace

bool Collision::exists() const { return access_->entities.slot(id_) != world::kNoSlot; }

std::string_view Collision::name() const { return record(*access_, id_).description->name; }

std::string Collision::scopedName() const { return link().scopedName() + "::" + std::string(name()); }

Link Collision::link() const { return Link(*access_, access_->entities.links()[record(*access_, id_).link].id); }

Pose Collision::poseInLink() const { return record(*access_, id_).description->X_LinkCollision; }

void Collision::setSurfaceMotion(const std::optional<SurfaceMotion>& motion) {
  const world::CollisionRecord& own = record(*access_, id_);
  if (motion) {
    const bool isFinite = std::abs(motion->speed) <= SurfaceMotion::kLargestSpeed && motion->axis.allFinite() &&
                          (!motion->center || motion->center->allFinite());
    if (!isFinite || !(motion->axis.norm() > 0)) {
      access_->refuse("the surface of collision '" + scopedName() +
                      "' can't move: the speed must be at most 1e6 m/s, the axis not zero and the centre finite");
      return;
    }
  }
  access_->engine.setSurfaceMotion(own.link, numberInLink(*access_, id_), motion);
}

std::optional<SurfaceMotion> Collision::surfaceMotion() const {
  return access_->engine.surfaceMotion(record(*access_, id_).link, numberInLink(*access_, id_));
}

void Collision::setSlip(double slip1, double slip2) {
  const world::CollisionRecord& own = record(*access_, id_);
  if (!(slip1 >= 0) || !(slip2 >= 0) || !std::isfinite(slip1) || !std::isfinite(slip2)) {
    access_->refuse("the slips of collision '" + scopedName() + "' must be finite and zero or more, in m/s/N");
    return;
  }
  access_->engine.setSlip(own.link, numberInLink(*access_, id_), slip1, slip2);
}

std::pair<double, double> Collision::slip() const {
  return access_->engine.slip(record(*access_, id_).link, numberInLink(*access_, id_));
}

Shape Collision::shape() const { return std::visit(ShapeOf(), record(*access_, id_).description->geometry); }

std::optional<MeshFile> Collision::meshFile() const {
  const auto* mesh = std::get_if<description::Mesh>(&record(*access_, id_).description->geometry);
  if (mesh == nullptr) return std::nullopt;
  const bool isThere = !mesh->file.empty();
  return MeshFile{isThere ? std::filesystem::absolute(mesh->file).lexically_normal() : mesh->file, mesh->submesh,
                  mesh->isCentered, mesh->scale};
}

SourcePosition Collision::sourcePosition() const { return record(*access_, id_).description->position; }

std::optional<Collision> World::collision(CollisionId id) const {
  if (access_->entities.slot(id) == world::kNoSlot) return std::nullopt;
  return Collision(*access_, id);
}

std::vector<Sensor> World::sensors(std::string_view type) const {
  std::vector<Sensor> handles;
  for (const world::SensorRecord& sensor : world::present(access_->entities.sensors())) {
    if (sensor.description->type == type) handles.push_back(Sensor(*access_, sensor.id));
  }
  return handles;
}

std::vector<Collision> Link::collisions() const {
  std::vector<Collision> handles;
  const world::Slot slot = slotOf(*access_, id_);
  for (const world::CollisionRecord& collision : access_->entities.collisions()) {
    if (collision.link == slot) handles.push_back(Collision(*access_, collision.id));
  }
  return handles;
}

std::vector<Visual> Link::visuals() const {
  std::vector<Visual> visuals;
  const world::LinkRecord& link = access_->entities.links()[slotOf(*access_, id_)];
  for (const description::Visual& visual : link.description->visuals) {
    visuals.emplace_back(world::visualId(link, visuals.size()), visual.name, visual.X_LinkVisual);
  }
  return visuals;
}

std::vector<Sensor> Link::sensors() const {
  std::vector<Sensor> handles;
  const world::Slot slot = slotOf(*access_, id_);
  for (const world::SensorRecord& sensor : access_->entities.sensors()) {
    if (sensor.link == slot) handles.push_back(Sensor(*access_, sensor.id));
  }
  return handles;
}

std::vector<Sensor> Joint::sensors() const {
  std::vector<Sensor> handles;
  const world::Slot slot = slotOf(*access_, id_);
  for (const world::SensorRecord& sensor : access_->entities.sensors()) {
    if (sensor.joint == slot) handles.push_back(Sensor(*access_, sensor.id));
  }
  return handles;
}

}  // namespace pongsim
