#include "base/geometry/triangulation.hh"

#include <algorithm>
#include <functional>

namespace pongsim::base {

namespace {

using Point = Eigen::Vector2d;
using Index = std::uint32_t;

bool isBetween(const Point& point, const Point& a, const Point& b) {
  return (point.array() >= a.array().min(b.array())).all() && (point.array() <= a.array().max(b.array())).all();
}

/// Works for both windings; edges count as inside.
bool isWithin(const Point& point, const Point& a, const Point& b, const Point& c) {
  const double ab = twiceArea(a, b, point), bc = twiceArea(b, c, point), ca = twiceArea(c, a, point);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

}  // namespace

double twiceArea(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool haveCommonPoint(const Point& a, const Point& b, const Point& c, const Point& d) {
  if ((a.cwiseMax(b).array() < c.cwiseMin(d).array()).any() || (c.cwiseMax(d).array() < a.cwiseMin(b).array()).any()) {
    return false;
  }
  const double abc = twiceArea(a, b, c), abd = twiceArea(a, b, d), cda = twiceArea(c, d, a), cdb = twiceArea(c, d, b);
  if (((abc > 0) != (abd > 0)) && ((cda > 0) != (cdb > 0)) && abc != 0 && abd != 0 && cda != 0 && cdb != 0) return true;
  return (abc == 0 && isBetween(c, a, b)) || (abd == 0 && isBetween(d, a, b)) || (cda == 0 && isBetween(a, c, d)) ||
         (cdb == 0 && isBetween(b, c, d));
}

bool encloses(const std::vector<Point>& line, const Point& point) {
  bool isInside = false;
  for (std::size_t i = 0, j = line.size() - 1; i < line.size(); j = i++) {
    const bool isCrossed = (line[i].y() > point.y()) != (line[j].y() > point.y());
    if (isCrossed && (twiceArea(line[j], line[i], point) > 0) == (line[i].y() > line[j].y())) isInside = !isInside;
  }
  return isInside;
}

void Triangulation::add(Loop loop, std::vector<Loop> holes) {
  const auto xOf = [this](Index index) { return at(index).x(); };
  for (Loop& hole : holes) std::ranges::rotate(hole, std::ranges::max_element(hole, {}, xOf));
  // from right to left: a hole is joined with what lies to its right
  std::ranges::sort(holes, std::greater<>(), [&](const Loop& hole) { return xOf(hole.front()); });
  for (const Loop& hole : holes) join(loop, hole);
  cut(std::move(loop));
}

/// Joins two loops into one, by an edge there and back between two points that see each other: see D. Eberly,
/// Triangulation by Ear Clipping, section 5. There is such a point to the right of a hole's rightmost point.
void Triangulation::join(Loop& loop, const Loop& hole) {
  const Point& eye = at(hole.front());
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (at(loop[i]).x() >= eye.x() && opensTo(loop, i, eye)) candidates.push_back(i);
  }
  const auto distance = [&](std::size_t i) { return (at(loop[i]) - eye).squaredNorm(); };
  std::ranges::sort(candidates, {}, distance);
  const auto seen = std::ranges::find_if(candidates, [&](std::size_t i) { return isSeen(loop, at(loop[i]), eye); });
  if (seen == candidates.end()) {
    isComplete_ = false;
    return;
  }
  Loop added(hole);
  added.push_back(hole.front());
  added.push_back(loop[*seen]);
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(*seen) + 1, added.begin(), added.end());
}

/// @return Whether the eye is between the two edges of a corner, on the filled side. If several corners are in one
/// place, because the loop passes it along joining edges, this holds for only one of them.
bool Triangulation::opensTo(const Loop& loop, std::size_t i, const Point& eye) const {
  const std::size_t count = loop.size();
  const Point &before = at(loop[(i + count - 1) % count]), &corner = at(loop[i]), &after = at(loop[(i + 1) % count]);
  const bool isLeftOfFirst = twiceArea(before, corner, eye) > 0, isLeftOfSecond = twiceArea(corner, after, eye) > 0;
  return twiceArea(before, corner, after) > 0 ? isLeftOfFirst && isLeftOfSecond : isLeftOfFirst || isLeftOfSecond;
}

/// @return Whether no edge lies between a point of the loop and the eye.
bool Triangulation::isSeen(const Loop& loop, const Point& point, const Point& eye) const {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point &a = at(loop[i]), &b = at(loop[(i + 1) % loop.size()]);
    if (a == point || b == point || !haveCommonPoint(a, b, point, eye)) continue;
    return false;
  }
  return true;
}

/// Cuts off one corner after the other (ear clipping).
void Triangulation::cut(Loop loop) {
  std::size_t i = 0, tries = 0;
  while (loop.size() > 2) {
    i %= loop.size();
    const std::size_t before = (i + loop.size() - 1) % loop.size(), after = (i + 1) % loop.size();
    // a flat corner is cut only if no other is left
    if (tries <= loop.size() && !isEar(loop, before, i, after)) {
      ++i;
      ++tries;
      continue;
    }
    triangles_.push_back({loop[before], loop[i], loop[after]});
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
    tries = 0;
  }
}

bool Triangulation::isEar(const Loop& loop, std::size_t before, std::size_t i, std::size_t after) const {
  const Point &a = at(loop[before]), &b = at(loop[i]), &c = at(loop[after]);
  if (!(twiceArea(a, b, c) > 0)) return false;
  for (std::size_t j = 0; j < loop.size(); ++j) {
    const Point& point = at(loop[j]);
    if (point == a || point == b || point == c) continue;
    if (isWithin(point, a, b, c)) return false;
  }
  return true;
}

}  // namespace pongsim::base
