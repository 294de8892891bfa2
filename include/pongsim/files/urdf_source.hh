#pragma once

#include <string>

#include "pongsim/element.hh"

namespace pongsim {

/// The URDF source of a model.
struct UrdfSource {
  /// The whole file or text, unchanged.
  std::string text;
  /// Its `<robot>` element, including elements unknown to URDF and SDF, such as `<ros2_control>` and `<transmission>`.
  Element robot;
  /// @return Whether the texts are equal.
  bool operator==(const UrdfSource& other) const { return text == other.text; }
};

}  // namespace pongsim
