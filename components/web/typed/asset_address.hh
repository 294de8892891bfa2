#pragma once

#include <string>
#include <string_view>

namespace pongsim::web::typed {

/// @return The text for a URI: all but letters, digits, "-._~" and the characters in `more` as %XX (RFC 3986).
std::string percentEncoded(std::string_view text, std::string_view more = {});

/// @param address As in a scene: "/home/me/arm.dae", "model://arm/arm.dae".
/// @return An address that Foxglove requests from the server, "package://pongsim/model/arm/arm.dae". It keeps the
/// folders, so that a mesh finds its textures.
std::string packageAddress(std::string_view address);

/// @return The original of an address made by `packageAddress`; other addresses unchanged.
std::string sceneAddress(std::string_view address);

}  // namespace pongsim::web::typed
