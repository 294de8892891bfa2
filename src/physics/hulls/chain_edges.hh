#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/hulls/triangle_chain.hh"

namespace pongsim::physics {

/// Sets of numbers that are united by and by (union by the smaller number).
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

/// @return The edges that are passed more often one way than the other, that way, in the order of their points'
/// numbers.
std::vector<DirectedEdge> boundaryOf(const std::vector<TriangleChain::Triangle>& triangles);

/// @return The edges in parts that have no point in common.
std::vector<std::vector<DirectedEdge>> connectedParts(const std::vector<DirectedEdge>& edges);

/// Closes what these edges bound by triangles from one of their points, which are caps.
void addFan(const std::vector<DirectedEdge>& boundary, std::vector<TriangleChain::Triangle>& triangles);

/// Two triangles with an edge in common, the only ones there.
struct Neighbours {
  std::size_t one, other;
  DirectedEdge edge;
  /// Whether both pass the edge the same way: one of them is turned round.
  bool areTwisted;
};
/// @return Those of all edges between triangles that are no caps, in the order of their points' numbers.
std::vector<Neighbours> neighboursIn(const std::vector<TriangleChain::Triangle>& triangles);

/// Turns triangles round until neighbours show the same side.
void orientAlike(std::vector<TriangleChain::Triangle>& triangles);

/// Takes out pairs of a triangle and the same one turned round.
void cancelOpposites(std::vector<TriangleChain::Triangle>& triangles);

}  // namespace pongsim::physics
