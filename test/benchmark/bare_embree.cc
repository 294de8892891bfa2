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
      const description::Color color =
          visual.material ? visual.material->diffuse : description::Color{0.7F, 0.7F, 0.7F, 1};
      colors_.emplace_back(color.red, color.green, color.blue);
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

/// Places in the picture [pixels], and what is there.
struct BareEmbree::Packet {
  static constexpr std::size_t kSize = 8;
  std::array<float, kSize> u, v;
  std::array<unsigned, kSize> visual;
  std::array<Eigen::Vector3f, kSize> normal, color;
};

void BareEmbree::trace(const PictureView& view, const Vector3& light, Packet& packet) const {
  constexpr std::size_t kSize = Packet::kSize;
  alignas(32) RTCRayHit8 rays{};
  alignas(32) std::array<int, kSize> areValid{};
  const Eigen::Matrix3f R = view.X_WorldEye.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f eye = view.X_WorldEye.position.cast<float>(), toLight = light.cast<float>();
  const auto fx = static_cast<float>(view.fx), fy = static_cast<float>(view.fy);
  const auto cx = static_cast<float>(view.cx), cy = static_cast<float>(view.cy);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  const auto set = [](auto& ray, std::size_t i, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) {
    ray.org_x[i] = origin.x(), ray.org_y[i] = origin.y(), ray.org_z[i] = origin.z();
    ray.dir_x[i] = direction.x(), ray.dir_y[i] = direction.y(), ray.dir_z[i] = direction.z();
    ray.mask[i] = std::numeric_limits<unsigned>::max();
  };
  std::array<Eigen::Vector3f, kSize> directions;
  for (std::size_t i = 0; i < kSize; ++i) {
    directions[i] = R * Eigen::Vector3f(1, (cx - packet.u[i]) / fx, (cy - packet.v[i]) / fy);
    set(rays.ray, i, eye, directions[i]);
    rays.ray.tnear[i] = static_cast<float>(view.near), rays.ray.tfar[i] = static_cast<float>(view.far);
    rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    areValid[i] = -1;
  }
  rtcIntersect8(areValid.data(), scene_->scene, &context, &rays);

  alignas(32) RTCRay8 shadows{};
  std::array<float, kSize> cosines{};
  for (std::size_t i = 0; i < kSize; ++i) {
    packet.visual[i] = rays.hit.geomID[i];
    Eigen::Vector3f normal = Eigen::Vector3f(rays.hit.Ng_x[i], rays.hit.Ng_y[i], rays.hit.Ng_z[i]).normalized();
    if (normal.dot(directions[i]) > 0) normal = -normal;
    packet.normal[i] = normal;
    cosines[i] = std::max(normal.dot(toLight), 0.0F);
    areValid[i] = packet.visual[i] != RTC_INVALID_GEOMETRY_ID && cosines[i] > 0 ? -1 : 0;
    set(shadows, i, eye + directions[i] * rays.ray.tfar[i] + normal * 1e-3F, toLight);
    shadows.tfar[i] = static_cast<float>(view.far);
  }
  rtcOccluded8(areValid.data(), scene_->scene, &context, &shadows);
  for (std::size_t i = 0; i < kSize; ++i) {
    const bool isHit = packet.visual[i] != RTC_INVALID_GEOMETRY_ID, isDark = shadows.tfar[i] < 0;
    packet.color[i] = isHit ? Eigen::Vector3f(colors_[packet.visual[i]] * (0.1F + (isDark ? 0 : 0.8F * cosines[i])))
                            : Eigen::Vector3f::Constant(0.45F);
  }
}

void BareEmbree::draw(const PictureView& view, const Vector3& light, std::span<std::uint8_t> pixels) const {
  const std::size_t width = view.width, count = width * view.height;
  std::vector<unsigned> visuals(count);
  std::vector<Eigen::Vector3f> normals(count), colors(count);
  Packet packet{};
  // four by two pixels
  for (std::size_t first = 0; first < count; first += first % width + 4 == width ? width + 4 : 4) {
    const auto pixelOf = [&](std::size_t i) { return first + i % 4 + i / 4 * width; };
    for (std::size_t i = 0; i < Packet::kSize; ++i) {
      packet.u[i] = static_cast<float>(pixelOf(i) % width) + 0.5F;
      packet.v[i] = static_cast<float>(pixelOf(i) / width) + 0.5F;
    }
    trace(view, light, packet);
    for (std::size_t i = 0; i < Packet::kSize; ++i) {
      visuals[pixelOf(i)] = packet.visual[i];
      normals[pixelOf(i)] = packet.normal[i];
      colors[pixelOf(i)] = packet.color[i];
    }
  }
  const auto differ = [&](std::size_t a, std::size_t b) {
    return visuals[a] != visuals[b] || normals[a].dot(normals[b]) < 0.9F;
  };
  std::vector<std::size_t> edges;
  for (std::size_t i = width; i + width < count; ++i) {
    if (differ(i, i - 1) || differ(i, i + 1) || differ(i, i - width) || differ(i, i + width)) edges.push_back(i);
  }
  // two pixels of four samples each
  constexpr std::array<float, 4> kRight{0.375F, 0.875F, 0.125F, 0.625F}, kDown{0.125F, 0.375F, 0.625F, 0.875F};
  for (std::size_t first = 0; first < edges.size(); first += 2) {
    for (std::size_t i = 0; i < Packet::kSize; ++i) {
      const std::size_t pixel = edges[std::min(first + i / 4, edges.size() - 1)];
      packet.u[i] = static_cast<float>(pixel % width) + kRight[i % 4];
      packet.v[i] = static_cast<float>(pixel / width) + kDown[i % 4];
    }
    trace(view, light, packet);
    for (std::size_t i = 0; i < 2 && first + i < edges.size(); ++i) {
      const auto* color = &packet.color[4 * i];
      colors[edges[first + i]] = (color[0] + color[1] + color[2] + color[3]) / 4;
    }
  }
  static const std::vector<std::uint8_t> kShown = [] {
    std::vector<std::uint8_t> shown;
    for (int i = 0; i <= 4096; ++i) {
      const double linear = i / 4096.0;
      const double share = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
      shown.push_back(static_cast<std::uint8_t>(std::lround(255 * share)));
    }
    return shown;
  }();
  for (std::size_t i = 0; i < count; ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      pixels[3 * i + static_cast<std::size_t>(channel)] =
          kShown[static_cast<std::size_t>(std::min(colors[i][channel], 1.0F) * 4096)];
    }
  }
}

}  // namespace pongsim::benchmark
