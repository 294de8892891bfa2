#include "sensing/mesh.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace pongsim::sensing {

namespace {

// of the size of the mesh: more than single precision errs by
constexpr double kMargin = 1e-5;

/// A question to Embree, and what its filter has to know.
struct MeshQuery {
  // stands first, for the filter is given its address
  RTCIntersectContext context;
  const description::TriangleMesh* mesh;
  Vector3 direction;
  bool seesInside;
};

struct Triangle {
  Vector3 corner;
  /// Of any length, to the side where the corners go round counter-clockwise.
  Vector3 normal;
};

Triangle triangleOf(const description::TriangleMesh& mesh, std::uint32_t index) {
  const auto& [a, b, c] = mesh.triangles[index];
  const Vector3& corner = mesh.vertices[a];
  return {corner, (mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner)};
}

/// Lets a beam through triangles that it meets from inside.
void dropHiddenSides(const RTCFilterFunctionNArguments* arguments) {
  const auto* query = reinterpret_cast<const MeshQuery*>(arguments->context);
  if (query->seesInside) return;
  const std::uint32_t index = RTCHitN_primID(arguments->hit, arguments->N, 0);
  if (triangleOf(*query->mesh, index).normal.dot(query->direction) >= 0) arguments->valid[0] = 0;
}

}  // namespace

Mesh::Mesh(RTCDevice device, std::shared_ptr<const description::TriangleMesh> triangles)
    : triangles_(std::move(triangles)), scene_(embree().newScene(device)) {
  for (const Vector3& vertex : triangles_->vertices) bounds_.extend(vertex);
  const GeometryPointer geometry(embree().newGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  auto* vertices = static_cast<float*>(embree().setNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), triangles_->vertices.size()));
  const Vector3 center = bounds_.center();
  for (const Vector3& vertex : triangles_->vertices) {
    for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(vertex[axis] - center[axis]);
  }
  auto* corners = static_cast<std::uint32_t*>(embree().setNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0,
                                                                            RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t),
                                                                            triangles_->triangles.size()));
  for (const auto& triangle : triangles_->triangles) corners = std::ranges::copy(triangle, corners).out;
  embree().setGeometryIntersectFilterFunction(geometry.get(), dropHiddenSides);
  embree().commitGeometry(geometry.get());
  embree().attachGeometry(scene_.get(), geometry.get());
  embree().setSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  embree().commitScene(scene_.get());
}

double Mesh::firstHit(const Line& line, double from, double to, bool seesInside) const {
  // from where it meets the box on, for what single precision errs by grows with the way
  const Vector3 middle = bounds_.center();
  const double size = bounds_.diagonal().norm();
  const Vector3 half = bounds_.sizes() / 2 + Vector3::Constant(kMargin * size);
  const auto within = boxPassage(half, {line.origin - middle, line.direction});
  if (!within) return kNowhere;
  const double begin = std::max(from, within->enter), end = std::min(to, within->leave);
  if (!(begin <= end)) return kNowhere;

  const double length = line.direction.norm();
  const Vector3 start = line.origin + begin * line.direction - middle;
  const Vector3 direction = line.direction / length;
  MeshQuery query{{}, triangles_.get(), line.direction, seesInside};
  rtcInitIntersectContext(&query.context);
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(start.x());
  ray.ray.org_y = static_cast<float>(start.y());
  ray.ray.org_z = static_cast<float>(start.z());
  ray.ray.dir_x = static_cast<float>(direction.x());
  ray.ray.dir_y = static_cast<float>(direction.y());
  ray.ray.dir_z = static_cast<float>(direction.z());
  ray.ray.tfar = static_cast<float>((end - begin) * length + kMargin * size);
  ray.ray.mask = std::numeric_limits<unsigned>::max();
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  embree().intersect1(scene_.get(), &query.context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return kNowhere;

  // which triangle it is, single precision tells; where it is met, double precision
  const Triangle triangle = triangleOf(*triangles_, ray.hit.primID);
  const double exact = triangle.normal.dot(triangle.corner - line.origin) / triangle.normal.dot(line.direction);
  const double rough = begin + static_cast<double>(ray.ray.tfar) / length;
  const bool isSound = std::abs(exact - rough) * length <= 100 * kMargin * size;
  const double found = std::max(isSound ? exact : rough, from);
  return found <= to ? found : kNowhere;
}

}  // namespace pongsim::sensing
