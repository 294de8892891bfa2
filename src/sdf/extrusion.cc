#include "sdf/extrusion.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

namespace pongsim::sdf {

namespace {

using Point = Eigen::Vector2d;
using Index = std::uint32_t;
/// Numbers of points, in the order of a closed line.
using Loop = std::vector<Index>;

/// @return Twice the area of the triangle, positive where it is wound counter-clockwise.
double area(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool isBetween(const Point& point, const Point& a, const Point& b) {
  return (point.array() >= a.array().min(b.array())).all() && (point.array() <= a.array().max(b.array())).all();
}

bool haveCommonPoint(const Point& a, const Point& b, const Point& c, const Point& d) {
  if ((a.cwiseMax(b).array() < c.cwiseMin(d).array()).any() || (c.cwiseMax(d).array() < a.cwiseMin(b).array()).any()) {
    return false;
  }
  const double abc = area(a, b, c), abd = area(a, b, d), cda = area(c, d, a), cdb = area(c, d, b);
  if (((abc > 0) != (abd > 0)) && ((cda > 0) != (cdb > 0)) && abc != 0 && abd != 0 && cda != 0 && cdb != 0) return true;
  return (abc == 0 && isBetween(c, a, b)) || (abd == 0 && isBetween(d, a, b)) || (cda == 0 && isBetween(a, c, d)) ||
         (cdb == 0 && isBetween(b, c, d));
}

/// @return Whether a line encloses the point, which is not on it.
bool encloses(const std::vector<Point>& line, const Point& point) {
  bool isInside = false;
  for (std::size_t i = 0, j = line.size() - 1; i < line.size(); j = i++) {
    const bool isCrossed = (line[i].y() > point.y()) != (line[j].y() > point.y());
    if (isCrossed && (area(line[j], line[i], point) > 0) == (line[i].y() > line[j].y())) isInside = !isInside;
  }
  return isInside;
}

/// Cuts the area within closed lines into triangles between their points.
class Triangulation {
 public:
  explicit Triangulation(const std::vector<Point>& points) : points_(points) {}

  /// @param loop Wound counter-clockwise.
  /// @param holes Within it, wound clockwise.
  void add(Loop loop, std::vector<Loop> holes) {
    const auto xOf = [this](Index index) { return at(index).x(); };
    for (Loop& hole : holes) std::ranges::rotate(hole, std::ranges::max_element(hole, {}, xOf));
    // from the right to the left: a hole is joined with what lies to its right
    std::ranges::sort(holes, std::greater<>(), [&](const Loop& hole) { return xOf(hole.front()); });
    for (const Loop& hole : holes) join(loop, hole);
    cut(std::move(loop));
  }

  std::vector<std::array<Index, 3>> take() { return std::move(triangles_); }

 private:
  const Point& at(Index index) const { return points_[index]; }

  /// Makes one line of two, by a way there and back between two points that see each other: see D. Eberly,
  /// Triangulation by Ear Clipping, section 5. From the right end of a hole there is such a point to its right.
  void join(Loop& loop, const Loop& hole) const {
    const Point& eye = at(hole.front());
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (at(loop[i]).x() >= eye.x() && opensTo(loop, i, eye)) candidates.push_back(i);
    }
    const auto distance = [&](std::size_t i) { return (at(loop[i]) - eye).squaredNorm(); };
    std::ranges::sort(candidates, {}, distance);
    const auto seen = std::ranges::find_if(candidates, [&](std::size_t i) { return isSeen(loop, at(loop[i]), eye); });
    if (seen == candidates.end()) return;
    Loop added(hole);
    added.push_back(hole.front());
    added.push_back(loop[*seen]);
    loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(*seen) + 1, added.begin(), added.end());
  }

  /// @return Whether the eye lies between the two edges of a corner, on the side that is filled. Of the corners in one
  /// place, where the line comes by on ways there and back, this is so for one.
  bool opensTo(const Loop& loop, std::size_t i, const Point& eye) const {
    const std::size_t count = loop.size();
    const Point &before = at(loop[(i + count - 1) % count]), &corner = at(loop[i]), &after = at(loop[(i + 1) % count]);
    const bool isLeftOfFirst = area(before, corner, eye) > 0, isLeftOfSecond = area(corner, after, eye) > 0;
    return area(before, corner, after) > 0 ? isLeftOfFirst && isLeftOfSecond : isLeftOfFirst || isLeftOfSecond;
  }

  /// @return Whether no edge stands between the point, which is one of the line's, and the eye.
  bool isSeen(const Loop& loop, const Point& point, const Point& eye) const {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point &a = at(loop[i]), &b = at(loop[(i + 1) % loop.size()]);
      if (a == point || b == point || !haveCommonPoint(a, b, point, eye)) continue;
      return false;
    }
    return true;
  }

  /// Whichever way the triangle is wound; its edges are within.
  static bool isWithin(const Point& point, const Point& a, const Point& b, const Point& c) {
    const double ab = area(a, b, point), bc = area(b, c, point), ca = area(c, a, point);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
  }

  /// Cuts off one corner after the other.
  void cut(Loop loop) {
    std::size_t i = 0, tries = 0;
    while (loop.size() > 2) {
      i %= loop.size();
      const std::size_t before = (i + loop.size() - 1) % loop.size(), after = (i + 1) % loop.size();
      // a flat corner goes without a triangle only where no other is left
      if (tries <= loop.size() && !isEar(loop, before, i, after)) {
        ++i;
        ++tries;
        continue;
      }
      if (area(at(loop[before]), at(loop[i]), at(loop[after])) > 0) {
        triangles_.push_back({loop[before], loop[i], loop[after]});
      }
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
      tries = 0;
    }
  }

  bool isEar(const Loop& loop, std::size_t before, std::size_t i, std::size_t after) const {
    const Point &a = at(loop[before]), &b = at(loop[i]), &c = at(loop[after]);
    if (!(area(a, b, c) > 0)) return false;
    for (std::size_t j = 0; j < loop.size(); ++j) {
      const Point& point = at(loop[j]);
      if (point == a || point == b || point == c) continue;
      if (isWithin(point, a, b, c)) return false;
    }
    return true;
  }

  const std::vector<Point>& points_;
  std::vector<std::array<Index, 3>> triangles_;
};

/// @return How many of the other lines each line lies within.
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
  for (std::size_t i = 1; i + 1 < line.size(); ++i) sum += area(line[0], line[i], line[i + 1]);
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
        // one after the other: they must not go back the way that they came
        const Point &common = b == c ? *b : *a, &one = b == c ? *a : *b, &other = b == c ? *d : *c;
        const bool areBoth = b == c && d == a;
        if (areBoth || (area(one, common, other) == 0 && (one - common).dot(other - common) > 0)) return true;
      } else if (haveCommonPoint(*a, *b, *c, *d)) {
        return true;
      }
    }
  }
  return false;
}

std::shared_ptr<const description::TriangleMesh> extrude(const Outline& outline, double height) {
  std::vector<Point> points;
  std::vector<Loop> loops;
  const std::vector<std::size_t> depths = depthsOf(outline);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    Loop& loop = loops.emplace_back();
    for (const Point& point : outline[i]) {
      loop.push_back(static_cast<Index>(points.size()));
      points.push_back(point);
    }
    // what is filled lies to the left of each line
    const bool isHole = depths[i] % 2 == 1;
    if (isCounterClockwise(outline[i]) == isHole) std::ranges::reverse(loop);
  }

  Triangulation triangulation(points);
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
