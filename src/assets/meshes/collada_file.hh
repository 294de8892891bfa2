#pragma once

#include <string>

namespace pongsim::assets {

/// Checks the content of a Collada file for Assimp, which does not check it.
/// @return Its XML without unused content, such as animations, weights of skins, lines and embedded images.
/// @throws std::runtime_error with the line and the fault.
std::string readCollada(const std::string& content);

}  // namespace pongsim::assets
