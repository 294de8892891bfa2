#include "msgs/scene/geometry_message.hh"

#include <ignition/msgs/geometry.pb.h>

#include <string>
#include <variant>

#include "msgs/scene/full_path.hh"
#include "msgs/scene/pose_message.hh"
#include "pongsim/messages/fields.hh"

namespace pongsim::msgs {

namespace {

namespace im = ignition::msgs;

struct GeometryWriter {
  im::Geometry& message;

  void operator()(const description::Empty&) const { message.set_type(im::Geometry::EMPTY); }

  void operator()(const description::Box& box) const {
    message.set_type(im::Geometry::BOX);
    setVector(box.size, *message.mutable_box()->mutable_size());
  }

  void operator()(const description::Sphere& sphere) const {
    message.set_type(im::Geometry::SPHERE);
    message.mutable_sphere()->set_radius(sphere.radius);
  }

  void operator()(const description::Cylinder& cylinder) const {
    message.set_type(im::Geometry::CYLINDER);
    message.mutable_cylinder()->set_radius(cylinder.radius);
    message.mutable_cylinder()->set_length(cylinder.length);
  }

  void operator()(const description::Capsule& capsule) const {
    message.set_type(im::Geometry::CAPSULE);
    message.mutable_capsule()->set_radius(capsule.radius);
    message.mutable_capsule()->set_length(capsule.length);
  }

  void operator()(const description::Cone& cone) const {
    message.set_type(im::Geometry::CONE);
    message.mutable_cone()->set_radius(cone.radius);
    message.mutable_cone()->set_length(cone.length);
  }

  void operator()(const description::Ellipsoid& ellipsoid) const {
    message.set_type(im::Geometry::ELLIPSOID);
    setVector(ellipsoid.radii, *message.mutable_ellipsoid()->mutable_radii());
  }

  void operator()(const description::Plane& plane) const {
    message.set_type(im::Geometry::PLANE);
    setVector(plane.normal, *message.mutable_plane()->mutable_normal());
    message.mutable_plane()->mutable_size()->set_x(plane.size.x());
    message.mutable_plane()->mutable_size()->set_y(plane.size.y());
  }

  void operator()(const description::Mesh& mesh) const {
    message.set_type(im::Geometry::MESH);
    message.mutable_mesh()->set_filename(pathOf(mesh));
    setVector(mesh.scale, *message.mutable_mesh()->mutable_scale());
    message.mutable_mesh()->set_submesh(mesh.submesh);
    message.mutable_mesh()->set_center_submesh(mesh.isCentered);
  }

  void operator()(const description::Heightmap& heightmap) const {
    message.set_type(im::Geometry::HEIGHTMAP);
    im::HeightmapGeom& ground = *message.mutable_heightmap();
    ground.set_filename(pathOf(heightmap));
    setVector(heightmap.size, *ground.mutable_size());
    setVector(heightmap.position, *ground.mutable_origin());
    ground.set_use_terrain_paging(heightmap.usesPaging);
    ground.set_sampling(heightmap.sampling);
    for (const description::HeightmapTexture& texture : heightmap.textures) {
      im::HeightmapGeom::Texture& added = *ground.add_texture();
      added.set_size(texture.size);
      added.set_diffuse(pathOf(texture.diffuse));
      added.set_normal(pathOf(texture.normal));
    }
    for (const description::HeightmapBlend& blend : heightmap.blends) {
      im::HeightmapGeom::Blend& added = *ground.add_blend();
      added.set_min_height(blend.minHeight);
      added.set_fade_dist(blend.fadeDistance);
    }
  }

  void operator()(const description::Polyline& polyline) const {
    message.set_type(im::Geometry::POLYLINE);
    for (const auto& line : polyline.lines) {
      im::Polyline& added = *message.add_polyline();
      added.set_height(polyline.height);
      for (const Eigen::Vector2d& point : line) {
        added.add_point()->set_x(point.x());
        added.mutable_point()->rbegin()->set_y(point.y());
      }
    }
  }

  void operator()(const description::Image& image) const {
    message.set_type(im::Geometry::IMAGE);
    im::ImageGeom& boxes = *message.mutable_image();
    boxes.set_uri(pathOf(image));
    boxes.set_scale(image.scale);
    boxes.set_threshold(static_cast<std::int32_t>(image.threshold));
    boxes.set_height(image.height);
    boxes.set_granularity(static_cast<std::int32_t>(image.granularity));
  }
};

}  // namespace

namespace {

Vector3 vectorOr(const im::Vector3d& vector, bool isThere, const Vector3& other) {
  return isThere ? vectorFrom(vector) : other;
}

description::Mesh meshOf(const im::MeshGeom& message) {
  description::Mesh mesh;
  mesh.uri = message.filename();
  mesh.submesh = message.submesh();
  mesh.isCentered = message.center_submesh();
  mesh.scale = vectorOr(message.scale(), message.has_scale(), mesh.scale);
  return mesh;
}

description::Heightmap heightmapOf(const im::HeightmapGeom& message) {
  description::Heightmap heightmap;
  heightmap.uri = message.filename();
  heightmap.size = vectorOr(message.size(), message.has_size(), heightmap.size);
  heightmap.position = vectorFrom(message.origin());
  heightmap.sampling = message.sampling();
  heightmap.usesPaging = message.use_terrain_paging();
  for (const im::HeightmapGeom::Texture& each : message.texture()) {
    heightmap.textures.push_back({each.size(), {each.diffuse(), {}}, {each.normal(), {}}});
  }
  for (const im::HeightmapGeom::Blend& each : message.blend()) {
    heightmap.blends.push_back({each.min_height(), each.fade_dist()});
  }
  return heightmap;
}

description::Polyline polylineOf(const im::Geometry& message) {
  description::Polyline polyline;
  for (const im::Polyline& each : message.polyline()) {
    polyline.height = each.height();
    auto& line = polyline.lines.emplace_back();
    for (const im::Vector2d& point : each.point()) line.emplace_back(point.x(), point.y());
  }
  return polyline;
}

}  // namespace

description::Geometry geometryFrom(const im::Geometry& message) {
  switch (message.type()) {
    case im::Geometry::BOX:
      return description::Box{vectorFrom(message.box().size())};
    case im::Geometry::SPHERE:
      return description::Sphere{message.sphere().radius()};
    case im::Geometry::CYLINDER:
      return description::Cylinder{message.cylinder().radius(), message.cylinder().length()};
    case im::Geometry::CAPSULE:
      return description::Capsule{message.capsule().radius(), message.capsule().length()};
    case im::Geometry::CONE:
      return description::Cone{message.cone().radius(), message.cone().length()};
    case im::Geometry::ELLIPSOID:
      return description::Ellipsoid{vectorFrom(message.ellipsoid().radii())};
    case im::Geometry::PLANE:
      return description::Plane{vectorFrom(message.plane().normal()),
                                {message.plane().size().x(), message.plane().size().y()}};
    case im::Geometry::MESH:
      return meshOf(message.mesh());
    case im::Geometry::HEIGHTMAP:
      return heightmapOf(message.heightmap());
    case im::Geometry::POLYLINE:
      return polylineOf(message);
    case im::Geometry::IMAGE:
      return description::Image{message.image().uri(),    {},
                                message.image().scale(),  message.image().threshold(),
                                message.image().height(), message.image().granularity()};
    default:
      return description::Empty{};
  }
}

void setGeometry(const description::Geometry& geometry, im::Geometry& message) {
  message.Clear();
  std::visit(GeometryWriter{message}, geometry);
}

}  // namespace pongsim::msgs
