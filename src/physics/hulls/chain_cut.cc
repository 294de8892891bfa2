#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "physics/hulls/chain_cap.hh"
#include "physics/hulls/triangle_chain.hh"

namespace pongsim::physics {

namespace {

using Triangle = TriangleChain::Triangle;
using Index = std::uint32_t;

/// Cuts the triangles of a chain; both sides get the same new points.
class Cutter {
 public:
  Cutter(const TriangleChain& chain, const Plane& plane, double tolerance)
      : chain_(chain), normal_(plane.normal), points_(chain.points) {
    heights_.reserve(points_.size());
    for (const Vector3& point : points_) {
      const double height = plane.normal.dot(point) - plane.distance;
      heights_.push_back(std::abs(height) <= tolerance ? 0 : height);
    }
    for (const Triangle& t : chain.triangles) add(t, plane.normal);
  }

  TriangleChain front(bool closes) { return side(front_, -normal_, closes); }
  TriangleChain back(bool closes) { return side(back_, normal_, closes); }

 private:
  void add(const Triangle& t, const Vector3& normal) {
    const std::array<double, 3> h{heights_[t.a], heights_[t.b], heights_[t.c]};
    const bool isAbove = h[0] > 0 || h[1] > 0 || h[2] > 0;
    const bool isBelow = h[0] < 0 || h[1] < 0 || h[2] < 0;
    if (isAbove && isBelow) {
      addPart(t, h, 1, front_);
      addPart(t, h, -1, back_);
    } else if (isAbove) {
      front_.push_back(t);
    } else if (isBelow) {
      back_.push_back(t);
    } else {
      // what it bounds lies behind it
      const Vector3 own = (points_[t.b] - points_[t.a]).cross(points_[t.c] - points_[t.a]);
      (own.dot(normal) > 0 ? back_ : front_).push_back(t);
    }
  }

  /// Adds the corners on one side and the points where edges meet the plane, as one or two triangles.
  void addPart(const Triangle& t, const std::array<double, 3>& h, int sign, std::vector<Triangle>& side) {
    const std::array<Index, 3> corners{t.a, t.b, t.c};
    std::array<Index, 4> part{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (h[i] * sign >= 0) part[count++] = corners[i];
      if (h[i] * h[j] < 0) part[count++] = between(corners[i], corners[j]);
    }
    for (std::size_t i = 2; i < count; ++i) side.push_back({part[0], part[i - 1], part[i], t.isCap});
  }

  Index between(Index a, Index b) {
    if (b < a) std::swap(a, b);
    const std::uint64_t edge = std::uint64_t{a} << 32U | b;
    const auto [place, isNew] = crossings_.try_emplace(edge, static_cast<Index>(points_.size()));
    if (isNew) {
      const double share = heights_[a] / (heights_[a] - heights_[b]);
      const Vector3 point = points_[a] + share * (points_[b] - points_[a]);
      points_.push_back(point);
    }
    return place->second;
  }

  TriangleChain side(std::vector<Triangle>& triangles, const Vector3& outwards, bool closes) {
    TriangleChain half;
    half.triangles = std::move(triangles);
    if (closes && chain_.isClosed) {
      addCap(points_, boundaryOf(half.triangles), outwards, half.triangles);
      half.isClosed = true;
    }
    std::vector<Index> place(points_.size(), ~Index{0});
    for (Triangle& t : half.triangles) {
      for (Index* corner : {&t.a, &t.b, &t.c}) {
        if (place[*corner] == ~Index{0}) {
          place[*corner] = static_cast<Index>(half.points.size());
          half.points.push_back(points_[*corner]);
        }
        *corner = place[*corner];
      }
    }
    return half;
  }

  const TriangleChain& chain_;
  const Vector3 normal_;
  std::vector<Vector3> points_;
  /// One for each point of the chain.
  std::vector<double> heights_;
  std::unordered_map<std::uint64_t, Index> crossings_;
  std::vector<Triangle> front_;
  std::vector<Triangle> back_;
};

}  // namespace

Halves cut(const TriangleChain& chain, const Plane& plane, double tolerance, bool closes) {
  Cutter cutter(chain, plane, tolerance);
  return {cutter.front(closes), cutter.back(closes)};
}

}  // namespace pongsim::physics
