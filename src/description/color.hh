#pragma once

namespace pongsim::description {

/// Linear components, 0 to 1; above 1 for lights brighter than an image can show.
struct Color {
  float red = 0;
  float green = 0;
  float blue = 0;
  /// 0: invisible, 1: opaque.
  float alpha = 1;
  bool operator==(const Color&) const = default;
};

}  // namespace pongsim::description
