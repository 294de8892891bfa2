#include "physics/hulls/chain_cap.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "base/geometry/triangulation.hh"

namespace pongsim::physics {

namespace {

using base::Loop;
using Point = Eigen::Vector2d;
using Index = std::uint32_t;

/// Joins the reversed edges to closed loops that pass each point at most once.
std::vector<Loop> loopsOf(const std::vector<DirectedEdge>& boundary) {
  std::unordered_map<Index, std::vector<Index>> next;
  for (const auto& [from, to] : boundary) next[to].push_back(from);
  std::vector<Loop> loops;
  for (const auto& [unused, start] : boundary) {
    Loop path{start};
    while (!next[path.back()].empty()) {
      std::vector<Index>& ways = next[path.back()];
      const Index to = ways.back();
      ways.pop_back();
      const auto met = std::ranges::find(path, to);
      if (met == path.end()) {
        path.push_back(to);
        continue;
      }
      loops.emplace_back(met, path.end());
      path.erase(met + 1, path.end());
    }
  }
  return loops;
}

class Cap {
 public:
  Cap(const std::vector<Vector3>& points, const std::vector<DirectedEdge>& boundary, const Vector3& outwards) {
    const Vector3 u = outwards.unitOrthogonal(), v = outwards.cross(u);
    for (const Loop& loop : loopsOf(boundary)) {
      Loop own;
      for (const Index index : loop) {
        own.push_back(static_cast<Index>(flat_.size()));
        flat_.emplace_back(u.dot(points[index]), v.dot(points[index]));
        numbers_.push_back(index);
      }
      loops_.push_back(std::move(own));
    }
    for (const Loop& loop : loops_) areas_.push_back(twiceAreaOf(loop));
  }

  /// @return Whether the triangles cover the area enclosed by the loops exactly once.
  bool fill() {
    base::Triangulation triangulation(flat_);
    std::vector<std::vector<Loop>> holes(loops_.size());
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (areas_[i] >= 0) continue;
      const std::size_t holder = holderOf(i);
      if (holder == loops_.size()) return false;
      holes[holder].push_back(loops_[i]);
    }
    double wanted = 0;
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      wanted += areas_[i];
      if (areas_[i] >= 0) triangulation.add(loops_[i], std::move(holes[i]));
    }
    if (!triangulation.isComplete()) return false;
    triangles_ = triangulation.take();
    double covered = 0;
    for (const auto& [a, b, c] : triangles_) covered += std::abs(base::twiceArea(flat_[a], flat_[b], flat_[c]));
    return covered <= wanted * (1 + 1e-6);
  }

  void give(std::vector<TriangleChain::Triangle>& triangles) const {
    for (const auto& [a, b, c] : triangles_) triangles.push_back({numbers_[a], numbers_[b], numbers_[c], true});
  }

 private:
  double twiceAreaOf(const Loop& loop) const {
    double sum = 0;
    for (std::size_t i = 2; i < loop.size(); ++i) {
      sum += base::twiceArea(flat_[loop[0]], flat_[loop[i - 1]], flat_[loop[i]]);
    }
    return sum;
  }

  /// @return The smallest loop around a hole; the number of loops if there is none.
  std::size_t holderOf(std::size_t hole) const {
    std::size_t holder = loops_.size();
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (areas_[i] < -areas_[hole] || (holder != loops_.size() && areas_[i] >= areas_[holder])) continue;
      std::vector<Point> line;
      for (const Index index : loops_[i]) line.push_back(flat_[index]);
      // loops may touch in places
      const auto isWithin = [&](Index index) { return base::encloses(line, flat_[index]); };
      if (2 * std::ranges::count_if(loops_[hole], isWithin) > std::ssize(loops_[hole])) holder = i;
    }
    return holder;
  }

  std::vector<Point> flat_;
  std::vector<Index> numbers_;
  std::vector<Loop> loops_;
  /// Twice the areas.
  std::vector<double> areas_;
  std::vector<std::array<Index, 3>> triangles_;
};

}  // namespace

void addCap(const std::vector<Vector3>& points, const std::vector<DirectedEdge>& boundary, const Vector3& outwards,
            std::vector<TriangleChain::Triangle>& triangles) {
  Cap cap(points, boundary, outwards);
  if (cap.fill()) {
    cap.give(triangles);
  } else {
    for (const auto& part : connectedParts(boundary)) addFan(part, triangles);
  }
}

}  // namespace pongsim::physics
