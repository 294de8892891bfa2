#include "benchmark/bare_embree.hh"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <variant>

#include "world/entities.hh"

namespace pongsim::benchmark {

namespace {

// segments of a circle, as many as Fortress draws
constexpr int kSegments = 32;

struct Triangles {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> corners;

  std::uint32_t add(const Vector3& vertex) {
    vertices.push_back(vertex);
    return static_cast<std::uint32_t>(vertices.size() - 1);
  }
  void addSquare(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    corners.push_back({a, b, c});
    corners.push_back({a, c, d});
  }
};

Vector3 onCircle(int segment, double radius, double z) {
  const double angle = 2 * std::numbers::pi * segment / kSegments;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// Adds a solid of revolution about z, through rings with these radii and heights.
void addRings(const std::vector<std::pair<double, double>>& rings, Triangles& triangles) {
  const auto first = static_cast<std::uint32_t>(triangles.vertices.size());
  for (const auto& [radius, z] : rings) {
    for (int i = 0; i < kSegments; ++i) triangles.add(onCircle(i, radius, z));
  }
  for (std::uint32_t ring = 0; ring + 1 < rings.size(); ++ring) {
    for (std::uint32_t i = 0; i < kSegments; ++i) {
      const std::uint32_t a = first + ring * kSegments + i, b = first + ring * kSegments + (i + 1) % kSegments;
      triangles.addSquare(a, b, b + kSegments, a + kSegments);
    }
  }
}

struct Triangulate {
  Triangles& triangles;

  void operator()(const description::Box& box) const {
    const Vector3 half = box.size / 2;
    std::array<std::uint32_t, 8> corner{};
    for (unsigned i = 0; i < 8; ++i) {
      const Vector3 sign((i & 1U) != 0 ? 1 : -1, (i & 2U) != 0 ? 1 : -1, (i & 4U) != 0 ? 1 : -1);
      corner[i] = triangles.add(half.cwiseProduct(sign));
    }
    constexpr std::array<std::array<unsigned, 4>, 6> kFaces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : kFaces) triangles.addSquare(corner[a], corner[b], corner[c], corner[d]);
  }
  void operator()(const description::Cylinder& cylinder) const {
    const double half = cylinder.length / 2;
    addRings({{0, -half}, {cylinder.radius, -half}, {cylinder.radius, half}, {0, half}}, triangles);
  }
  void operator()(const description::Sphere& sphere) const {
    std::vector<std::pair<double, double>> rings;
    for (int i = 0; i <= kSegments; ++i) {
      const double angle = std::numbers::pi * i / kSegments;
      rings.emplace_back(sphere.radius * std::sin(angle), -sphere.radius * std::cos(angle));
    }
    addRings(rings, triangles);
  }
  void operator()(const description::Plane& plane) const {
    const double x = plane.size.x() / 2, y = plane.size.y() / 2;
    const std::uint32_t first = triangles.add({-x, -y, 0});
    for (const Vector3& corner : {Vector3(x, -y, 0), Vector3(x, y, 0), Vector3(-x, y, 0)}) triangles.add(corner);
    triangles.addSquare(first, first + 1, first + 2, first + 3);
  }
  template <class Other>
  void operator()(const Other&) const {
    throw std::runtime_error("the world has a shape that is not compared");
  }
};

}  // namespace

struct BareEmbree::Scene {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
};

BareEmbree::BareEmbree(const description::World& world) : scene_(std::make_unique<Scene>()) {
  const world::Entities entities(world);
  for (const world::LinkRecord& link : entities.links()) {
    for (const description::Visual& visual : link.description->visuals) {
      Triangles triangles;
      std::visit(Triangulate{triangles}, visual.geometry);
      size_ += triangles.corners.size();
      const Pose X_WorldVisual = link.X_WorldLinkStart * visual.X_LinkVisual;
      RTCGeometry geometry = rtcNewGeometry(scene_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
      auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 12, triangles.vertices.size()));
      for (const Vector3& each : triangles.vertices) {
        const Vector3 point = X_WorldVisual * each;
        for (int axis = 0; axis < 3; ++axis) *vertex++ = static_cast<float>(point[axis]);
      }
      auto* corner = static_cast<std::uint32_t*>(
          rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles.corners.size()));
      for (const auto& each : triangles.corners) corner = std::copy(each.begin(), each.end(), corner);
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene_->scene, geometry);
      rtcReleaseGeometry(geometry);
    }
  }
  rtcCommitScene(scene_->scene);
}

BareEmbree::~BareEmbree() {
  rtcReleaseScene(scene_->scene);
  rtcReleaseDevice(scene_->device);
}

void BareEmbree::cast(const Vector3& origin, const std::vector<Vector3>& directions, double farthest,
                      std::vector<float>& ranges) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(origin.x());
    ray.ray.org_y = static_cast<float>(origin.y());
    ray.ray.org_z = static_cast<float>(origin.z());
    ray.ray.dir_x = static_cast<float>(directions[i].x());
    ray.ray.dir_y = static_cast<float>(directions[i].y());
    ray.ray.dir_z = static_cast<float>(directions[i].z());
    ray.ray.tfar = static_cast<float>(farthest);
    ray.ray.mask = std::numeric_limits<unsigned>::max();
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_->scene, &context, &ray);
    ranges[i] = ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::infinity() : ray.ray.tfar;
  }
}

}  // namespace pongsim::benchmark
