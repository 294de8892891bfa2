#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cli/view/sight.hh"

namespace pongsim::cli {

/// A name and the place in a picture over which it is to stand [pixels].
struct Label {
  std::string text;
  double column = 0;
  double row = 0;
};

/// @return The names of the models at the top level and of the actors, each over the corner of the box around it that
/// is highest in the picture, or over its middle where they are all beside it; those that are not in the picture have
/// none.
std::vector<Label> labelsOf(Sight& sight, const PictureView& view);

/// Writes labels into a picture, over all that it shows: each above its place, and as far above as it takes not to
/// cover those below it. What goes beyond the picture is cut off.
/// @param pixels As those of `CameraScene::drawColors`.
void drawLabels(std::vector<Label> labels, std::uint32_t width, std::uint32_t height, std::span<std::uint8_t> pixels);

}  // namespace pongsim::cli
