#pragma once

#include <cstddef>

#include "pongsim/outcome.hh"
#include "video/encoder.hh"

namespace pongsim::video {

/// Encodes images from a file until its end, and completes the video. Each is its frame, a number of 8 bytes in the
/// order of this machine, and its pixels. A last one that is cut off is left out. Without any, there is no video.
/// @param input File descriptor.
/// @param imageSize Of the pixels [bytes].
Outcome<void> encodeStream(int input, std::size_t imageSize, Encoder& encoder);

}  // namespace pongsim::video
