#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cli/view/sight.hh"

namespace pongsim::cli {

/// A name and its position in an image [pixels].
struct Label {
  std::string text;
  double column = 0;
  double row = 0;
};

/// @return The names of the visible top-level models and actors, each above the highest corner of its bounding box in
/// the image, or above its centre if all corners are outside.
std::vector<Label> labelsOf(Sight& sight, const PictureView& view);

/// Draws labels over an image, each above its position, and moved up as far as needed not to cover those below it.
/// Clipped at the edges of the image.
/// @param pixels As those of `CameraScene::drawColors`.
void drawLabels(std::vector<Label> labels, std::uint32_t width, std::uint32_t height, std::span<std::uint8_t> pixels);

}  // namespace pongsim::cli
