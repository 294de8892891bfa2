#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace pongsim::sdf {

/// Stands for no node.
inline constexpr std::size_t kNoNode = std::numeric_limits<std::size_t>::max();

/// The order in which to visit nodes that each follow at most one other, as a frame follows the one it is relative to.
struct FrameOrder {
  /// Every node that does not lead into a cycle, after the one that it follows.
  std::vector<std::size_t> order;
  /// Each cycle once, starting at its lowest node: each node follows the next, and the last one the first.
  std::vector<std::vector<std::size_t>> cycles;
};

/// @param next The node that each node follows, or `kNoNode`. Takes linear time.
FrameOrder orderFrames(std::span<const std::size_t> next);

}  // namespace pongsim::sdf
