#pragma once

namespace pongsim::description {

/// Shares of light, linear, 0 to 1; more than 1 in lights that are brighter than a picture can show.
struct Color {
  float red = 0;
  float green = 0;
  float blue = 0;
  /// 0: not to be seen, 1: not to be seen through.
  float alpha = 1;
  bool operator==(const Color&) const = default;
};

}  // namespace pongsim::description
