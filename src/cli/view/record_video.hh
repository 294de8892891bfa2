#pragma once

#include <cstdint>
#include <span>

#include "cli/view/painter.hh"
#include "cli/view/sight.hh"
#include "cli/view/view_command.hh"

namespace pongsim::cli {

/// Draws a picture as the options say, and the names over it.
void drawPicture(const ViewOptions& options, Sight& sight, const PictureView& view, Painter& painter,
                 std::span<std::uint8_t> pixels);

/// Lets the world go on, and draws it as a video. Reports failures; what could be drawn before is kept.
/// @param view From where, at the beginning.
/// @return The exit code.
int recordVideo(const ViewOptions& options, Sight& sight, PictureView view);

}  // namespace pongsim::cli
