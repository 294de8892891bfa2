#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "pongsim/message.hh"

namespace pongsim::msgs {

/// A colour image.
struct ImagePixels {
  std::size_t width = 0;
  std::size_t height = 0;
  /// Red, green, blue, row by row from the top.
  std::vector<std::uint8_t> pixels;
};

/// @param image An `ignition.msgs.Image`. In depth images (R_FLOAT32) the nearest pixel is white, the farthest nearly
/// black, and non-finite values are black.
/// @return Nothing if it has no pixels, less data than it claims, or a format other than RGB_INT8, BGR_INT8, L_INT8,
/// L_INT16 and R_FLOAT32.
std::optional<ImagePixels> pixelsOf(const Message& image);

}  // namespace pongsim::msgs
