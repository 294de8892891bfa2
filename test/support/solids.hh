#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "description/triangle_mesh.hh"
#include "sdf/readers/shapes/extrusion.hh"

namespace pongsim::test {

using description::TriangleMesh;

inline void append(const TriangleMesh& part, TriangleMesh& whole) {
  const auto first = static_cast<std::uint32_t>(whole.vertices.size());
  whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
  for (const auto& [a, b, c] : part.triangles) whole.triangles.push_back({first + a, first + b, first + c});
}

inline TriangleMesh turnedInsideOut(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

inline TriangleMesh moved(TriangleMesh mesh, const Pose& X) {
  for (Vector3& vertex : mesh.vertices) vertex = X * vertex;
  return mesh;
}

inline TriangleMesh boxBetween(const Vector3& low, const Vector3& high) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                               (i & 4) != 0 ? high.z() : low.z());
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// @return The solid of revolution of a closed line of (radius, z), counter-clockwise, about z, in `count` steps.
inline TriangleMesh turned(const std::vector<std::pair<double, double>>& line, std::uint32_t count) {
  TriangleMesh mesh;
  const auto length = static_cast<std::uint32_t>(line.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    for (const auto& [r, z] : line) mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t j = 0; j < length; ++j) {
      const std::uint32_t a = i * length + j, b = i * length + (j + 1) % length;
      const std::uint32_t c = (i + 1) % count * length + (j + 1) % length, d = (i + 1) % count * length + j;
      mesh.triangles.push_back({a, d, c});
      mesh.triangles.push_back({a, c, b});
    }
  }
  return mesh;
}

/// Half of a spherical shell, open upwards, with its centre in the origin: about 4 * rings * count triangles.
inline TriangleMesh bowl(double radius, double thickness, std::uint32_t count, int rings) {
  std::vector<std::pair<double, double>> line;
  const auto add = [&](double r, int i) {
    const double angle = std::numbers::pi / 2 * i / rings;
    line.emplace_back(r * std::sin(angle), -r * std::cos(angle));
  };
  for (int i = 0; i <= rings; ++i) add(radius, i);
  for (int i = rings; i >= 0; --i) add(radius - thickness, i);
  return turned(line, count);
}

/// An L in the xz plane, `width` along y, with its corner in the origin. In multiples of `unit` its legs are 3 long
/// along x and 2 along z, and 1 wide.
inline TriangleMesh angleIron(double unit, double width) {
  const sdf::Outline outline{{{0, 0}, {3 * unit, 0}, {3 * unit, unit}, {unit, unit}, {unit, 2 * unit}, {0, 2 * unit}}};
  const TriangleMesh flat = *sdf::extrude(outline, width);
  // z becomes -y
  return moved(flat, {{0, width / 2, 0}, fromRollPitchYaw(std::numbers::pi / 2, 0, 0)});
}

/// A wheel with its axle along y: a rim of `count` sides, spokes and a hub, united into one surface.
inline TriangleMesh spokedWheel(double radius, double width, std::uint32_t count, int spokes) {
  const double rim = 0.12 * radius, hub = 0.2 * radius, half = width / 2;
  TriangleMesh wheel = turned({{radius - rim, -half}, {radius, -half}, {radius, half}, {radius - rim, half}}, count);
  append(turned({{0, -half}, {hub, -half}, {hub, half}, {0, half}}, count), wheel);
  for (int i = 0; i < spokes; ++i) {
    const double angle = 2 * std::numbers::pi * i / spokes;
    append(moved(boxBetween({0, -0.05 * radius, -half / 2}, {radius - rim / 2, 0.05 * radius, half / 2}),
                 {{0, 0, 0}, fromRollPitchYaw(0, 0, angle)}),
           wheel);
  }
  return moved(wheel, {{0, 0, 0}, fromRollPitchYaw(std::numbers::pi / 2, 0, 0)});
}

/// @return The mesh as a Wavefront file.
inline std::string asObj(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(12);
  text << "o mesh\n";
  for (const Vector3& v : mesh.vertices) text << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const auto& [a, b, c] : mesh.triangles) text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  return text.str();
}

}  // namespace pongsim::test
