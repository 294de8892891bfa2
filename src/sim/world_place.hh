#pragma once

#include <cstddef>

namespace pongsim::sim {

/// Where a world stands in its file.
struct WorldPlace {
  /// From 0 on.
  std::size_t number = 0;
  /// Whether no other one of the file is simulated beside it.
  bool isAlone = true;
};

}  // namespace pongsim::sim
