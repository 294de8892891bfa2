#include "description/cone_triangles.hh"

#include <cmath>
#include <numbers>

#include "pongsim/math.hh"

namespace pongsim::description {

TriangleMesh coneTriangles(const Cone& cone) {
  constexpr std::uint32_t kSides = 48, kTip = kSides, kMiddle = kSides + 1;
  constexpr double kAngle = 2 * std::numbers::pi / kSides;
  // of the polygon with the circle's area, pi r^2 = kSides / 2 R^2 sin kAngle
  const double radius = cone.radius * std::sqrt(kAngle / math::sin(kAngle));
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    mesh.vertices.emplace_back(radius * math::cos(i * kAngle), radius * math::sin(i * kAngle), -cone.length / 2);
  }
  mesh.vertices.emplace_back(0, 0, cone.length / 2);
  mesh.vertices.emplace_back(0, 0, -cone.length / 2);
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t next = (i + 1) % kSides;
    mesh.triangles.push_back({i, next, kTip});
    mesh.triangles.push_back({next, i, kMiddle});
  }
  return mesh;
}

}  // namespace pongsim::description
