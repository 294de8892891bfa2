#include "rendering/surface.hh"

#include <array>
#include <cmath>
#include <numbers>

namespace pongsim::rendering {

namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using std::numbers::pi;

// round enough for an image: a circle is off by 0.2 % of its radius
constexpr int kSectors = 48;
constexpr int kRings = 24;

/// Adds the quadrilateral with four corners in counter-clockwise order.
void addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, Surface& surface) {
  for (const std::uint32_t corner : {a, b, c, a, c, d}) surface.corners.push_back(corner);
}

/// A point of a profile that is rotated about z.
struct ProfilePoint {
  double radius;
  double z;
  /// Outward.
  double normalRadius;
  double normalZ;
};

/// Adds the surface of revolution of a profile, from its top down.
void addTurned(const std::vector<ProfilePoint>& profile, Surface& surface) {
  const auto first = static_cast<std::uint32_t>(surface.vertices.size());
  for (std::size_t row = 0; row < profile.size(); ++row) {
    const ProfilePoint& point = profile[row];
    for (int column = 0; column <= kSectors; ++column) {
      const double angle = 2 * pi * column / kSectors, x = std::cos(angle), y = std::sin(angle);
      surface.vertices.push_back(
          {Vector3f(Vector3(point.radius * x, point.radius * y, point.z).cast<float>()),
           Vector3f(Vector3(point.normalRadius * x, point.normalRadius * y, point.normalZ).cast<float>()),
           Vector2f(static_cast<float>(column) / kSectors,
                    static_cast<float>(row) / static_cast<float>(profile.size() - 1))});
    }
  }
  for (std::uint32_t row = 0; row + 1 < profile.size(); ++row) {
    for (std::uint32_t column = 0; column < kSectors; ++column) {
      const std::uint32_t above = first + row * (kSectors + 1) + column, below = above + kSectors + 1;
      addQuad(above, below, below + 1, above + 1, surface);
    }
  }
}

/// Adds points of a circular arc to a profile.
/// @param from, to Angles from the top [rad].
void addArc(double radius, double middleZ, double from, double to, int steps, std::vector<ProfilePoint>& profile) {
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps, s = std::sin(angle), c = std::cos(angle);
    profile.push_back({radius * s, middleZ + radius * c, s, c});
  }
}

/// Adds a disc of radius 1, visible from above or from below.
void addDisc(double z, bool isSeenFromAbove, Surface& surface) {
  const auto middle = static_cast<std::uint32_t>(surface.vertices.size());
  const Vector3f normal(0, 0, isSeenFromAbove ? 1 : -1);
  surface.vertices.push_back({{0, 0, static_cast<float>(z)}, normal, {0.5F, 0.5F}});
  for (int i = 0; i <= kSectors; ++i) {
    const double angle = 2 * pi * i / kSectors;
    const auto x = static_cast<float>(std::cos(angle)), y = static_cast<float>(std::sin(angle));
    surface.vertices.push_back({{x, y, static_cast<float>(z)}, normal, {0.5F + x / 2, 0.5F - y / 2}});
  }
  for (std::uint32_t i = 1; i <= kSectors; ++i) {
    const std::uint32_t a = middle + i, b = middle + i + 1;
    for (const std::uint32_t corner : {middle, isSeenFromAbove ? a : b, isSeenFromAbove ? b : a}) {
      surface.corners.push_back(corner);
    }
  }
}

Vector3f normalOf(const description::TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Vector3& a = mesh.vertices[triangle[0]];
  const Vector3 normal = (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
  return normal.stableNormalized().cast<float>();
}

}  // namespace

Eigen::AlignedBox3d Surface::bounds() const {
  Eigen::AlignedBox3f box;
  for (const Vertex& vertex : vertices) box.extend(vertex.position);
  return box.cast<double>();
}

Surface boxSurface() {
  Surface surface;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0F, 1.0F}) {
      Vector3f normal = Vector3f::Zero();
      normal[axis] = side;
      // right and up, looking at the face: up is z, or y on top and bottom
      const Vector3f up = axis == 2 ? Vector3f::UnitY() : Vector3f::UnitZ();
      const Vector3f right = up.cross(normal);
      const auto first = static_cast<std::uint32_t>(surface.vertices.size());
      for (const Vector2f& corner : {Vector2f(0, 1), Vector2f(1, 1), Vector2f(1, 0), Vector2f(0, 0)}) {
        surface.vertices.push_back(
            {normal / 2 + (corner.x() - 0.5F) * right + (0.5F - corner.y()) * up, normal, corner});
      }
      addQuad(first, first + 1, first + 2, first + 3, surface);
    }
  }
  return surface;
}

Surface sphereSurface() {
  std::vector<ProfilePoint> profile;
  addArc(1, 0, 0, pi, kRings, profile);
  Surface surface;
  addTurned(profile, surface);
  return surface;
}

Surface cylinderSurface() {
  Surface surface;
  addTurned({{1, 0.5, 1, 0}, {1, -0.5, 1, 0}}, surface);
  addDisc(0.5, true, surface);
  addDisc(-0.5, false, surface);
  return surface;
}

Surface coneSurface() {
  Surface surface;
  // the tip has a normal for each sector
  const double across = 1 / std::sqrt(2);
  addTurned({{0, 0.5, across, across}, {1, -0.5, across, across}}, surface);
  addDisc(-0.5, false, surface);
  return surface;
}

Surface capsuleSurface(const description::Capsule& capsule) {
  std::vector<ProfilePoint> profile;
  addArc(capsule.radius, capsule.length / 2, 0, pi / 2, kRings / 2, profile);
  addArc(capsule.radius, -capsule.length / 2, pi / 2, pi, kRings / 2, profile);
  Surface surface;
  addTurned(profile, surface);
  return surface;
}

Surface planeSurface() {
  Surface surface;
  for (const Vector2f& corner : {Vector2f(0, 1), Vector2f(1, 1), Vector2f(1, 0), Vector2f(0, 0)}) {
    surface.vertices.push_back({{corner.x() - 0.5F, 0.5F - corner.y(), 0}, Vector3f::UnitZ(), corner});
  }
  addQuad(0, 1, 2, 3, surface);
  return surface;
}

Surface meshSurface(const description::TriangleMesh& mesh, bool isSmooth) {
  Surface surface;
  if (isSmooth) {
    for (const Vector3& vertex : mesh.vertices) surface.vertices.push_back({vertex.cast<float>(), Vector3f::Zero()});
    for (const auto& triangle : mesh.triangles) {
      const Vector3f normal = normalOf(mesh, triangle);
      for (const std::uint32_t corner : triangle) {
        surface.vertices[corner].normal += normal;
        surface.corners.push_back(corner);
      }
    }
    for (Vertex& vertex : surface.vertices) vertex.normal = vertex.normal.stableNormalized();
    return surface;
  }
  for (const auto& triangle : mesh.triangles) {
    const Vector3f normal = normalOf(mesh, triangle);
    for (const std::uint32_t corner : triangle) {
      surface.corners.push_back(static_cast<std::uint32_t>(surface.vertices.size()));
      surface.vertices.push_back({mesh.vertices[corner].cast<float>(), normal});
    }
  }
  return surface;
}

}  // namespace pongsim::rendering
