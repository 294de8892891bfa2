#pragma once

#include "pongsim/types.hh"

namespace pongsim::world {

/// The colour of a visual since it was changed.
struct NewColor {
  /// Red, green, blue, 0 to 1.
  Vector3 color;
  /// Whether it emits this colour.
  bool glows = false;
};

}  // namespace pongsim::world
