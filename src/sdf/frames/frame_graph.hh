#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace pongsim::sdf {

/// In place of a node: it follows none.
inline constexpr std::size_t kNoNode = std::numeric_limits<std::size_t>::max();

/// How to walk through nodes each of which follows at most one other, as a frame follows the one it is relative to.
struct FrameOrder {
  /// Every node that does not lead into a cycle, behind the one that it follows.
  std::vector<std::size_t> order;
  /// Each cycle once, beginning at its lowest node: each node follows the next, the last one the first.
  std::vector<std::vector<std::size_t>> cycles;
};

/// @param next The node that each follows, or `kNoNode`. Takes linear time.
FrameOrder orderFrames(std::span<const std::size_t> next);

}  // namespace pongsim::sdf
