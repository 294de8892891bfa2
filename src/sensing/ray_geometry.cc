#include "sensing/ray_geometry.hh"

#include <utility>

#include "assets/meshes/ground.hh"
#include "pongsim/geometry/rotation_between.hh"

namespace pongsim::sensing {

namespace {

using description::TriangleMesh;

struct MakeRayGeometry {
  assets::MeshStore& meshes;
  const RayGeometryReader::Warn& warn;

  RayGeometry operator()(const description::Empty&) const { return {}; }
  // as in Fortress
  RayGeometry operator()(const description::Image&) const { return {}; }
  RayGeometry operator()(const description::Box& box) const { return {Shape(box)}; }
  RayGeometry operator()(const description::Sphere& sphere) const { return {Shape(sphere)}; }
  RayGeometry operator()(const description::Cylinder& cylinder) const { return {Shape(cylinder)}; }
  RayGeometry operator()(const description::Capsule& capsule) const { return {Shape(capsule)}; }
  RayGeometry operator()(const description::Cone& cone) const { return {Shape(cone)}; }
  RayGeometry operator()(const description::Ellipsoid& ellipsoid) const { return {Shape(ellipsoid)}; }

  // as large as its visual, as in Fortress
  RayGeometry operator()(const description::Plane& plane) const {
    return {Shape(Sheet{plane.size.cwiseAbs() / 2}),
            {Vector3::Zero(), rotationBetween(Vector3::UnitZ(), plane.normal)}};
  }

  RayGeometry operator()(const description::Polyline& polyline) const {
    if (polyline.triangles == nullptr) return {};
    return {polyline.triangles};
  }

  // the loader has warned about missing files, here and below
  RayGeometry operator()(const description::Mesh& mesh) const {
    if (mesh.file.empty()) return {};
    const assets::MeshStore::Result found = meshes.find(mesh.file, mesh.submesh, mesh.isCentered);
    if (const auto* problem = std::get_if<assets::Problem>(&found)) {
      warn("mesh", mesh.file, *problem);
      return {};
    }
    return {std::get<0>(found), {}, mesh.scale};
  }

  RayGeometry operator()(const description::Heightmap& heightmap) const {
    if (heightmap.file.empty()) return {};
    auto ground = assets::readGround(heightmap.file, heightmap.size, heightmap.position);
    if (const auto* problem = std::get_if<assets::Problem>(&ground)) {
      warn("heightmap", heightmap.file, *problem);
      return {};
    }
    if (std::get<0>(ground).triangles.empty()) return {};
    return {std::make_shared<const TriangleMesh>(std::move(std::get<0>(ground)))};
  }
};

}  // namespace

RayGeometry RayGeometryReader::read(const description::Geometry& geometry, const Warn& warn) {
  return std::visit(MakeRayGeometry{meshes_, warn}, geometry);
}

}  // namespace pongsim::sensing
