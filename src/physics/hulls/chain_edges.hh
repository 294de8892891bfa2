#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/hulls/triangle_chain.hh"

namespace pongsim::physics {

/// Disjoint sets of numbers (union-find; the smaller number becomes the representative).
class Sets {
 public:
  explicit Sets(std::size_t count);
  std::size_t rootOf(std::size_t member);
  void unite(std::size_t a, std::size_t b);

 private:
  std::vector<std::size_t> parents_;
};

struct DirectedEdge {
  std::uint32_t from, to;
};

/// @return The edges that are passed more often one way than the other, in that direction, sorted by their points'
/// numbers.
std::vector<DirectedEdge> boundaryOf(const std::vector<TriangleChain::Triangle>& triangles);

/// @return The edges grouped into parts that have no point in common.
std::vector<std::vector<DirectedEdge>> connectedParts(const std::vector<DirectedEdge>& edges);

/// Closes the area bounded by these edges with triangles from one of their points, marked as caps.
void addFan(const std::vector<DirectedEdge>& boundary, std::vector<TriangleChain::Triangle>& triangles);

/// Two triangles that share an edge with no others.
struct Neighbours {
  std::size_t one, other;
  DirectedEdge edge;
  /// Whether both pass the edge the same way, so one of them is flipped.
  bool areTwisted;
};
/// @return The neighbours at all edges between triangles other than caps, sorted by their points' numbers.
std::vector<Neighbours> neighboursIn(const std::vector<TriangleChain::Triangle>& triangles);

/// Flips triangles until neighbours face the same side.
void orientAlike(std::vector<TriangleChain::Triangle>& triangles);

/// Removes pairs of a triangle and its flipped copy.
void cancelOpposites(std::vector<TriangleChain::Triangle>& triangles);

}  // namespace pongsim::physics
