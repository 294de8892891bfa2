#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace pongsim::web::gz {

/// @param image An ignition.msgs.Image in binary form.
/// @return The image as PNG, in colour or grey; depth and thermal images from white, the smallest value, to black.
/// Nothing if the bytes are not an image, have an unsupported format, or lack pixels.
std::optional<std::string> picture(std::span<const std::byte> image);

}  // namespace pongsim::web::gz
