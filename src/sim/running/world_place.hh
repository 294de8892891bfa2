#pragma once

#include <cstddef>

namespace pongsim::sim {

/// Position of a world in its file.
struct WorldPlace {
  /// Index, from 0.
  std::size_t number = 0;
  /// Whether it is the only simulated world of the file.
  bool isAlone = true;
};

}  // namespace pongsim::sim
