#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace pongsim::web::gz {

/// @param image An ignition.msgs.Image in its binary form.
/// @return The image as PNG, coloured or grey; depths and heat from white, the smallest, to black. Nothing where the
/// bytes are no image, or one of a format that has no picture, or lack pixels.
std::optional<std::string> picture(std::span<const std::byte> image);

}  // namespace pongsim::web::gz
