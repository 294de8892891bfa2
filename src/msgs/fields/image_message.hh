#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "pongsim/message.hh"

namespace pongsim::msgs {

/// A picture in colours.
struct ImagePixels {
  std::size_t width = 0;
  std::size_t height = 0;
  /// Red, green, blue, row by row from the top.
  std::vector<std::uint8_t> pixels;
};

/// @param image An `ignition.msgs.Image`. Of distances (R_FLOAT32) the nearest is white, the farthest nearly black, and
/// what is not finite black.
/// @return Nothing where it has no pixels, less data than it says, or another format than RGB_INT8, BGR_INT8, L_INT8,
/// L_INT16 and R_FLOAT32.
std::optional<ImagePixels> pixelsOf(const Message& image);

}  // namespace pongsim::msgs
