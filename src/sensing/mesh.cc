#include "sensing/mesh.hh"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace pongsim::sensing {

namespace {

// error of single precision relative to the size of the mesh, with reserve
constexpr double kMeshMargin = 1e-5;

/// A search for the first hit, and its result so far.
struct MeshQuery {
  // First member, since Embree passes its address to the callback.
  RTCIntersectContext context;
  const description::TriangleMesh& mesh;
  const Line& line;
  /// Where Embree's ray begins: on the line, in lengths of its direction, and in the frame of the mesh.
  double begin;
  Vector3 start;
  /// Hits before it do not count, likewise.
  double from;
  bool seesInside;
  /// The nearest hit so far, or the limit of the search, likewise.
  double nearest;
  /// Error of single precision [m].
  double margin;
  /// Of the line's direction.
  double length;
  bool isHit;
};

/// @return Where the line meets a triangle, in lengths of its direction. The line passes through the triangle if the
/// volumes that its direction spans with each two corners have the same sign. The two triangles at an edge compute the
/// same volume with opposite signs, so a line along the edge hits at least one of them.
std::optional<double> meet(const MeshQuery& query, std::uint32_t index) {
  const auto& [first, second, third] = query.mesh.triangles[index];
  const auto& vertices = query.mesh.vertices;
  const Vector3& direction = query.line.direction;
  const Vector3 normal = (vertices[second] - vertices[first]).cross(vertices[third] - vertices[first]);
  const double towards = normal.dot(direction);
  if (towards == 0 || (towards > 0 && !query.seesInside)) return std::nullopt;
  const Vector3 a = vertices[first] - query.start, b = vertices[second] - query.start,
                c = vertices[third] - query.start;
  const double ab = direction.dot(a.cross(b)), bc = direction.dot(b.cross(c)), ca = direction.dot(c.cross(a));
  const bool isThrough = (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
  if (!isThrough) return std::nullopt;
  return normal.dot(vertices[first] - query.line.origin) / towards;
}

void meetTriangle(const RTCIntersectFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  auto& query = *reinterpret_cast<MeshQuery*>(arguments->context);
  const auto found = meet(query, arguments->primID);
  if (!found || *found < query.from || *found > query.nearest) return;
  query.nearest = *found;
  query.isHit = true;
  float& end = RTCRayN_tfar(RTCRayHitN_RayN(arguments->rayhit, arguments->N), arguments->N, 0);
  end = std::min(end, static_cast<float>((*found - query.begin) * query.length + query.margin));
}

}  // namespace

Mesh::Mesh(RTCDevice device, std::shared_ptr<const description::TriangleMesh> triangles)
    : triangles_(std::move(triangles)), scene_(embree().newScene(device)) {
  for (const Vector3& vertex : triangles_->vertices) bounds_.extend(vertex);
  const GeometryPointer geometry(embree().newGeometry(device, RTC_GEOMETRY_TYPE_USER));
  embree().setGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(triangles_->triangles.size()));
  // valid for the commit below only, because this object may be moved afterwards
  embree().setGeometryUserData(geometry.get(), this);
  embree().setGeometryBoundsFunction(geometry.get(), writeBounds, nullptr);
  embree().setGeometryIntersectFunction(geometry.get(), meetTriangle);
  embree().commitGeometry(geometry.get());
  embree().attachGeometry(scene_.get(), geometry.get());
  embree().setSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  embree().commitScene(scene_.get());
}

void Mesh::writeBounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& mesh = *static_cast<const Mesh*>(arguments->geometryUserPtr);
  const Vector3 middle = mesh.bounds_.center();
  Eigen::AlignedBox3d box;
  for (const std::uint32_t corner : mesh.triangles_->triangles[arguments->primID]) {
    box.extend(Vector3(mesh.triangles_->vertices[corner] - middle));
  }
  const Vector3 margin = Vector3::Constant(kMeshMargin * mesh.bounds_.diagonal().norm());
  const Eigen::Vector3f least = (box.min() - margin).cast<float>(), most = (box.max() + margin).cast<float>();
  *arguments->bounds_o = {least.x(), least.y(), least.z(), 0, most.x(), most.y(), most.z(), 0};
}

double Mesh::firstHit(const Line& line, double from, double to, bool seesInside) const {
  // the ray begins at the box, because the error of single precision grows with its length
  const Vector3 middle = bounds_.center();
  const double size = bounds_.diagonal().norm();
  const Vector3 half = bounds_.sizes() / 2 + Vector3::Constant(kMeshMargin * size);
  const auto within = boxPassage(half, {line.origin - middle, line.direction});
  if (!within) return kNowhere;
  const double begin = std::max(from, within->enter), end = std::min(to, within->leave);
  if (!(begin <= end)) return kNowhere;

  const double length = line.direction.norm(), margin = kMeshMargin * size;
  const Vector3 start = line.origin + begin * line.direction;
  const Vector3 origin = start - middle, direction = line.direction / length;
  MeshQuery query{{}, *triangles_, line, begin, start, from, seesInside, to, margin, length, false};
  rtcInitIntersectContext(&query.context);
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(origin.x());
  ray.ray.org_y = static_cast<float>(origin.y());
  ray.ray.org_z = static_cast<float>(origin.z());
  ray.ray.dir_x = static_cast<float>(direction.x());
  ray.ray.dir_y = static_cast<float>(direction.y());
  ray.ray.dir_z = static_cast<float>(direction.z());
  ray.ray.tfar = static_cast<float>((end - begin) * length + margin);
  ray.ray.mask = std::numeric_limits<unsigned>::max();
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  embree().intersect1(scene_.get(), &query.context, &ray);
  return query.isHit ? query.nearest : kNowhere;
}

}  // namespace pongsim::sensing
