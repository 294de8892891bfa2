#include "sdf/readers/shapes/extrusion.hh"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/geometry/triangulation.hh"

namespace pongsim::sdf {

namespace {

using base::encloses;
using base::haveCommonPoint;
using base::Loop;
using base::twiceArea;
using Point = Eigen::Vector2d;
using Index = std::uint32_t;

/// @return For each line, how many of the others enclose it.
std::vector<std::size_t> depthsOf(const Outline& outline) {
  std::vector<std::size_t> depths(outline.size(), 0);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    for (std::size_t j = 0; j < outline.size(); ++j) {
      if (i != j && encloses(outline[j], outline[i].front())) ++depths[i];
    }
  }
  return depths;
}

bool isCounterClockwise(const std::vector<Point>& line) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) sum += twiceArea(line[0], line[i], line[i + 1]);
  return sum > 0;
}

}  // namespace

bool crosses(const Outline& outline) {
  struct Edge {
    const Point* a;
    const Point* b;
  };
  std::vector<Edge> edges;
  for (const std::vector<Point>& line : outline) {
    for (std::size_t i = 0; i < line.size(); ++i) edges.push_back({&line[i], &line[(i + 1) % line.size()]});
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const auto [a, b] = edges[i];
      const auto [c, d] = edges[j];
      if (b == c || d == a) {
        // edges that share a point must not overlap beyond it
        const Point &common = b == c ? *b : *a, &one = b == c ? *a : *b, &other = b == c ? *d : *c;
        const bool areBoth = b == c && d == a;
        if (areBoth || (twiceArea(one, common, other) == 0 && (one - common).dot(other - common) > 0)) return true;
      } else if (haveCommonPoint(*a, *b, *c, *d)) {
        return true;
      }
    }
  }
  return false;
}

std::shared_ptr<const description::TriangleMesh> extrude(const Outline& outline, double height) {
  assert(height > 0 && std::ranges::all_of(outline, [](const auto& line) { return line.size() >= 3; }));
  std::vector<Point> points;
  std::vector<Loop> loops;
  const std::vector<std::size_t> depths = depthsOf(outline);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    Loop& loop = loops.emplace_back();
    for (const Point& point : outline[i]) {
      loop.push_back(static_cast<Index>(points.size()));
      points.push_back(point);
    }
    // the filled side is to the left of each line
    const bool isHole = depths[i] % 2 == 1;
    if (isCounterClockwise(outline[i]) == isHole) std::ranges::reverse(loop);
  }

  base::Triangulation triangulation(points);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (depths[i] % 2 == 1) continue;
    std::vector<Loop> holes;
    for (std::size_t j = 0; j < loops.size(); ++j) {
      if (depths[j] == depths[i] + 1 && encloses(outline[i], outline[j].front())) holes.push_back(loops[j]);
    }
    triangulation.add(loops[i], std::move(holes));
  }

  auto mesh = std::make_shared<description::TriangleMesh>();
  const auto top = static_cast<Index>(points.size());
  for (const double z : {0.0, height}) {
    for (const Point& point : points) mesh->vertices.emplace_back(point.x(), point.y(), z);
  }
  for (const auto& [a, b, c] : triangulation.take()) {
    if (!(twiceArea(points[a], points[b], points[c]) > 0)) continue;
    mesh->triangles.push_back({a, c, b});
    mesh->triangles.push_back({top + a, top + b, top + c});
  }
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index a = loop[i], b = loop[(i + 1) % loop.size()];
      mesh->triangles.push_back({a, b, top + b});
      mesh->triangles.push_back({a, top + b, top + a});
    }
  }
  return mesh;
}

}  // namespace pongsim::sdf
