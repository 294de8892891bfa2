#include "web/typed/scene_update.hh"

#include <string>
#include <utility>

#include "web/server/media_type.hh"
#include "web/typed/asset_address.hh"
#include "web/typed/parts.hh"

namespace pongsim::web::typed {

namespace {

namespace im = ignition::msgs;
using ::foxglove::SceneEntity;

// Size at which an infinite plane is drawn.
constexpr double kPlaneSide = 100;

void fillInColor(const im::Visual& visual, ::foxglove::Color& color) {
  const bool hasDiffuse = visual.has_material() && visual.material().has_diffuse();
  const im::Color& diffuse = visual.material().diffuse();
  color.set_r(hasDiffuse ? diffuse.r() : 0.7);
  color.set_g(hasDiffuse ? diffuse.g() : 0.7);
  color.set_b(hasDiffuse ? diffuse.b() : 0.7);
  color.set_a((hasDiffuse ? diffuse.a() : 1) * (1 - visual.transparency()));
}

/// Fills in the fields that all primitives have, except sizes.
template <class Primitive>
Primitive& begin(const im::Visual& visual, Primitive& primitive) {
  fillIn(visual.pose(), *primitive.mutable_pose());
  fillInColor(visual, *primitive.mutable_color());
  return primitive;
}

void addBall(const im::Visual& visual, double x, double y, double z, SceneEntity& entity) {
  fillIn(x, y, z, *begin(visual, *entity.add_spheres()).mutable_size());
}

void addCylinder(const im::Visual& visual, double radius, double length, double topScale, SceneEntity& entity) {
  auto& cylinder = begin(visual, *entity.add_cylinders());
  fillIn(2 * radius, 2 * radius, length, *cylinder.mutable_size());
  cylinder.set_bottom_scale(1);
  cylinder.set_top_scale(topScale);
}

void addCapsule(const im::Visual& visual, SceneEntity& entity) {
  const im::CapsuleGeom& capsule = visual.geometry().capsule();
  addCylinder(visual, capsule.radius(), capsule.length(), 1, entity);
  for (const double end : {-0.5, 0.5}) {
    addBall(visual, 2 * capsule.radius(), 2 * capsule.radius(), 2 * capsule.radius(), entity);
    // along the capsule's own z axis, in the orientation of the visual
    ::foxglove::Pose& pose = *entity.mutable_spheres(entity.spheres_size() - 1)->mutable_pose();
    const ::foxglove::Quaternion& q = pose.orientation();
    const double z = end * capsule.length();
    auto& place = *pose.mutable_position();
    place.set_x(place.x() + 2 * (q.x() * q.z() + q.w() * q.y()) * z);
    place.set_y(place.y() + 2 * (q.y() * q.z() - q.w() * q.x()) * z);
    place.set_z(place.z() + (1 - 2 * (q.x() * q.x() + q.y() * q.y())) * z);
  }
}

/// A rectangle perpendicular to the normal, as two triangles.
void addPlane(const im::Visual& visual, SceneEntity& entity) {
  const im::PlaneGeom& plane = visual.geometry().plane();
  const double x = plane.size().x() > 0 ? plane.size().x() / 2 : kPlaneSide / 2;
  const double y = plane.size().y() > 0 ? plane.size().y() / 2 : kPlaneSide / 2;
  auto& triangles = begin(visual, *entity.add_triangles());
  const im::Vector3d& n = plane.normal();
  // corners in the x-y plane, rotated from z to the normal by the smallest angle (Rodrigues' formula)
  const bool isUp = n.x() == 0 && n.y() == 0;
  const double length = n.x() * n.x() + n.y() * n.y();
  const double tilt = isUp ? 0 : (1 - n.z()) / length;
  for (const auto& [right, up] : {std::pair{-x, -y}, {x, -y}, {x, y}, {-x, -y}, {x, y}, {-x, y}}) {
    auto& point = *triangles.add_points();
    point.set_x(right * (1 - n.x() * n.x() * tilt) - up * n.x() * n.y() * tilt);
    point.set_y(up * (1 - n.y() * n.y() * tilt) - right * n.x() * n.y() * tilt);
    point.set_z(-right * n.x() - up * n.y());
  }
}

void addMesh(const im::Visual& visual, SceneEntity& entity) {
  const im::MeshGeom& mesh = visual.geometry().mesh();
  auto& model = begin(visual, *entity.add_models());
  fillIn(mesh.scale().x(), mesh.scale().y(), mesh.scale().z(), *model.mutable_scale());
  model.set_url(packageAddress(mesh.filename()));
  model.set_media_type(std::string(mediaType(mesh.filename())));
}

void addShape(const im::Visual& visual, SceneEntity& entity) {
  const im::Geometry& shape = visual.geometry();
  switch (shape.type()) {
    case im::Geometry::BOX:
      fillIn(shape.box().size().x(), shape.box().size().y(), shape.box().size().z(),
             *begin(visual, *entity.add_cubes()).mutable_size());
      break;
    case im::Geometry::SPHERE: {
      const double size = 2 * shape.sphere().radius();
      addBall(visual, size, size, size, entity);
      break;
    }
    case im::Geometry::ELLIPSOID: {
      const im::Vector3d& radii = shape.ellipsoid().radii();
      addBall(visual, 2 * radii.x(), 2 * radii.y(), 2 * radii.z(), entity);
      break;
    }
    case im::Geometry::CYLINDER:
      addCylinder(visual, shape.cylinder().radius(), shape.cylinder().length(), 1, entity);
      break;
    case im::Geometry::CONE:
      addCylinder(visual, shape.cone().radius(), shape.cone().length(), 0, entity);
      break;
    case im::Geometry::CAPSULE:
      addCapsule(visual, entity);
      break;
    case im::Geometry::PLANE:
      addPlane(visual, entity);
      break;
    case im::Geometry::MESH:
      addMesh(visual, entity);
      break;
    default:
      break;
  }
}

void addModel(const im::Model& model, const std::string& frame, std::uint64_t timeNs, ::foxglove::SceneUpdate& update) {
  for (const auto& link : model.link()) {
    SceneEntity& entity = *update.add_entities();
    fillIn(timeNs, *entity.mutable_timestamp());
    entity.set_frame_id(frame + "::" + link.name());
    entity.set_id(entity.frame_id());
    entity.set_frame_locked(true);
    for (const auto& visual : link.visual()) addShape(visual, entity);
  }
  for (const auto& nested : model.model()) addModel(nested, frame + "::" + nested.name(), timeNs, update);
}

}  // namespace

::foxglove::SceneUpdate sceneUpdate(const im::Scene& scene, std::uint64_t timeNs) {
  ::foxglove::SceneUpdate update;
  auto& deletion = *update.add_deletions();
  fillIn(timeNs, *deletion.mutable_timestamp());
  deletion.set_type(::foxglove::SceneEntityDeletion::ALL);
  for (const auto& model : scene.model()) addModel(model, model.name(), timeNs, update);
  return update;
}

}  // namespace pongsim::web::typed
