#pragma once

#include <string>

#include "pongsim/element.hh"

namespace pongsim {

/// What a model was made from, where that was URDF.
struct UrdfSource {
  /// The whole file, or the text that was sent, to the letter.
  std::string text;
  /// Its `<robot>`, with what URDF and SDF know nothing of, as `<ros2_control>` and `<transmission>`.
  Element robot;
  /// @return Whether the text is the same.
  bool operator==(const UrdfSource& other) const { return text == other.text; }
};

}  // namespace pongsim
