#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace pongsim::sdf {

/// Stands for no node.
inline constexpr std::size_t kNoNode = std::numeric_limits<std::size_t>::max();

/// A topological order of nodes, each of which depends on at most one other, as a frame on the one it is relative to.
struct FrameOrder {
  /// Every node that does not lead into a cycle, after the one that it depends on.
  std::vector<std::size_t> order;
  /// Each cycle once, starting at its lowest node: each node depends on the next, and the last one on the first.
  std::vector<std::vector<std::size_t>> cycles;
};

/// @param next The node that each node depends on, or `kNoNode`. Takes linear time.
FrameOrder orderFrames(std::span<const std::size_t> next);

}  // namespace pongsim::sdf
