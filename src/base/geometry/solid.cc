#include "pongsim/geometry/solid.hh"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "base/geometry/volume_below.hh"

namespace pongsim {

namespace {

/// @return The moments of a body after scaling.
VolumeMoments scaled(const VolumeMoments& part, const Vector3& scale) {
  const double size = std::abs(scale.prod());
  return {size * part.volume, size * scale.cwiseProduct(part.first)};
}

/// @return The part of a scaled body below a plane, computed from the part of the unscaled body.
template <class Below>
VolumeMoments scaledBelow(const Vector3& scale, const Vector3& up, double height, Below below) {
  const Vector3 slope = scale.cwiseProduct(up);
  const double length = slope.norm();
  return scaled(below(slope / length, height / length), scale);
}

struct BelowOf {
  const Vector3& up;
  double height;

  VolumeMoments operator()(const NoShape&) const { return {}; }
  VolumeMoments operator()(const PlaneShape&) const { return {}; }
  VolumeMoments operator()(const BoxShape& box) const { return base::boxBelow(box.size, up, height); }
  VolumeMoments operator()(const SphereShape& sphere) const { return Ball{sphere.radius}.below(up, height); }
  VolumeMoments operator()(const CylinderShape& cylinder) const {
    return base::cylinderBelow(cylinder.radius, cylinder.length, up, height);
  }
  VolumeMoments operator()(const CapsuleShape& capsule) const {
    VolumeMoments sum = base::cylinderBelow(capsule.radius, capsule.length, up, height);
    for (const double side : {1.0, -1.0}) {
      const double middle = side * capsule.length / 2;
      VolumeMoments end =
          base::halfBallBelow(capsule.radius, {up.x(), up.y(), side * up.z()}, height - middle * up.z());
      end.first.z() = side * end.first.z() + middle * end.volume;
      sum += end;
    }
    return sum;
  }
  VolumeMoments operator()(const EllipsoidShape& ellipsoid) const {
    return scaledBelow(ellipsoid.radii, up, height,
                       [](const Vector3& slope, double rise) { return Ball{1}.below(slope, rise); });
  }
  VolumeMoments operator()(const TriangleShape& mesh) const {
    return scaledBelow(mesh.scale, up, height, [&mesh](const Vector3& slope, double rise) {
      return base::trianglesBelow(mesh.vertices, mesh.triangles, slope, rise);
    });
  }
};

struct BoundsOf {
  using Box = Eigen::AlignedBox3d;

  Box operator()(const NoShape&) const { return {}; }
  Box operator()(const PlaneShape&) const { return {}; }
  Box operator()(const BoxShape& box) const { return {-box.size / 2, box.size / 2}; }
  Box operator()(const SphereShape& sphere) const { return around(Vector3::Constant(sphere.radius)); }
  Box operator()(const CylinderShape& shape) const { return around({shape.radius, shape.radius, shape.length / 2}); }
  Box operator()(const CapsuleShape& shape) const {
    return around({shape.radius, shape.radius, shape.length / 2 + shape.radius});
  }
  Box operator()(const EllipsoidShape& ellipsoid) const { return around(ellipsoid.radii); }
  Box operator()(const TriangleShape& mesh) const {
    Box box;
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t vertex : triangle) box.extend(mesh.scale.cwiseProduct(mesh.vertices[vertex]));
    }
    return box;
  }
  static Box around(const Vector3& half) { return {-half, half}; }
};

struct VolumeOf {
  const Eigen::AlignedBox3d& bounds;

  // all of a body lies below a plane above it
  template <class Any>
  VolumeMoments operator()(const Any& shape) const {
    if (bounds.isEmpty()) return {};
    VolumeMoments all = BelowOf{Vector3::UnitZ(), bounds.max().z()}(shape);
    // these shapes are centred on the origin; avoids rounding errors
    all.first.setZero();
    return all;
  }
  VolumeMoments operator()(const TriangleShape& mesh) const {
    // tetrahedra with apex at the origin
    VolumeMoments all;
    for (const auto& triangle : mesh.triangles) {
      const Vector3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]], &c = mesh.vertices[triangle[2]];
      const double volume = a.dot(b.cross(c)) / 6;
      all += {volume, volume / 4 * (a + b + c)};
    }
    return scaled(all, mesh.scale);
  }
};

/// Prisms, for planes that cut only their sides.
struct PrismOf {
  template <class Any>
  Prism operator()(const Any&) const {
    return {};
  }
  Prism operator()(const BoxShape& box) const { return Prism(box); }
  Prism operator()(const CylinderShape& cylinder) const { return Prism(cylinder); }
  Prism operator()(const CapsuleShape& capsule) const { return Prism(capsule); }
};

Volume volumeOf(const VolumeMoments& moments) {
  if (!(moments.volume > 0)) return {};
  return {moments.volume, moments.first / moments.volume};
}

/// @return For each vertex the first one in the same place.
std::vector<std::uint32_t> weld(std::span<const Vector3> vertices) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) { return std::array{vertices[i].x(), vertices[i].y(), vertices[i].z()}; };
  std::ranges::sort(order,
                    [&](std::uint32_t a, std::uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<std::uint32_t> first(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool isNew = i == 0 || vertices[order[i]] != vertices[order[i - 1]];
    first[order[i]] = isNew ? order[i] : first[order[i - 1]];
  }
  return first;
}

bool isClosedSurface(const TriangleShape& mesh) {
  const std::vector<std::uint32_t> same = weld(mesh.vertices);
  // the two ends, the lower one first, and the triangle's direction along the edge
  std::vector<std::pair<std::uint64_t, int>> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t from = same[triangle[i]], to = same[triangle[(i + 1) % 3]];
      if (from != to) edges.emplace_back(std::min(from, to) << 32U | std::max(from, to), from < to ? 1 : -1);
    }
  }
  std::ranges::sort(edges);
  for (std::size_t i = 0; i < edges.size();) {
    int ways = 0;
    const std::uint64_t edge = edges[i].first;
    for (; i < edges.size() && edges[i].first == edge; ++i) ways += edges[i].second;
    if (ways != 0) return false;
  }
  return !edges.empty();
}

}  // namespace

Solid::Solid(Shape shape) : shape_(std::move(shape)) {
  bounds_ = std::visit(BoundsOf(), shape_);
  const VolumeMoments all = std::visit(VolumeOf{bounds_}, shape_);
  orientation_ = all.volume < 0 ? -1 : 1;
  if (all.volume != 0) moments_ = oriented(all);
  isCentered_ = moments_.first.isZero(0);
  volume_ = volumeOf(moments_);
  if (bounds_.isEmpty()) return;
  radius_ = bounds_.sizes().norm() / 2;
  prism_ = std::visit(PrismOf(), shape_);
  if (const auto* sphere = std::get_if<SphereShape>(&shape_)) ball_ = {sphere->radius};
}

bool Solid::isClosed() const {
  if (const auto* mesh = std::get_if<TriangleShape>(&shape_)) return isClosedSurface(*mesh);
  return volume_.size > 0;
}

VolumeMoments Solid::oriented(const VolumeMoments& moments) const {
  return {orientation_ * moments.volume, orientation_ * moments.first};
}

Volume Solid::below(const Vector3& up, double height) const { return volumeOf(momentsBelow(up, height)); }

VolumeMoments Solid::momentsBelowElsewhere(const Vector3& up, double height) const {
  if (!(moments_.volume > 0)) return {};
  const double middle = up.dot(bounds_.center());
  const double half = up.cwiseAbs().dot(bounds_.sizes()) / 2;
  if (height >= middle + half) return moments_;
  if (height <= middle - half) return {};
  VolumeMoments part = oriented(std::visit(BelowOf{up, height}, shape_));
  // rounding, or a surface that is not closed
  if (!(part.volume > 0)) return {};
  if (part.volume > moments_.volume) {
    part.first *= moments_.volume / part.volume;
    part.volume = moments_.volume;
  }
  return part;
}

VolumeMoments Solid::momentsBelowLevelElsewhere(const Quaternion& R_WorldSolid, double height) const {
  VolumeMoments part = momentsBelowElsewhere(R_WorldSolid.conjugate() * Vector3::UnitZ(), height);
  part.first = R_WorldSolid * part.first;
  return part;
}

}  // namespace pongsim
