#include "sdf/frames/frame_graph.hh"

#include <algorithm>
#include <cassert>

namespace pongsim::sdf {

FrameOrder orderFrames(std::span<const std::size_t> next) {
  enum class Mark : char { kNew, kOnPath, kOrdered, kLost };
  std::vector<Mark> marks(next.size(), Mark::kNew);
  std::vector<std::size_t> path;
  FrameOrder result;
  result.order.reserve(next.size());

  for (std::size_t start = 0; start < next.size(); ++start) {
    // follow the nodes to a known one, to the end, or back into the path itself
    path.clear();
    std::size_t node = start;
    while (node != kNoNode && marks[node] == Mark::kNew) {
      marks[node] = Mark::kOnPath;
      path.push_back(node);
      node = next[node];
      assert(node == kNoNode || node < next.size());
    }
    const bool isCycle = node != kNoNode && marks[node] == Mark::kOnPath;
    const bool isLost = isCycle || (node != kNoNode && marks[node] == Mark::kLost);

    if (isCycle) {
      std::vector<std::size_t> cycle(std::find(path.begin(), path.end(), node), path.end());
      std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
      result.cycles.push_back(std::move(cycle));
    }
    for (std::size_t i = path.size(); i-- > 0;) {
      marks[path[i]] = isLost ? Mark::kLost : Mark::kOrdered;
      if (!isLost) result.order.push_back(path[i]);
    }
  }
  return result;
}

}  // namespace pongsim::sdf
