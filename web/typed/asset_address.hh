#pragma once

#include <string>
#include <string_view>

namespace pongsim::web::typed {

/// @param address As a scene has it: "/home/me/arm.dae", "model://arm/arm.dae".
/// @return The same as an address that Foxglove asks the server for, "package://pongsim/model/arm/arm.dae", with its
/// folders, so that a mesh finds its pictures.
std::string packageAddress(std::string_view address);

/// @return What `packageAddress` was made of; other addresses as they are.
std::string sceneAddress(std::string_view address);

}  // namespace pongsim::web::typed
