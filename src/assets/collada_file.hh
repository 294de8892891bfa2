#pragma once

#include <filesystem>
#include <string>

namespace pongsim::assets {

/// Reads and checks a Collada file for Assimp, which does not check it.
/// @return Its XML without unused content, such as animations, weights of skins, lines and embedded images.
/// @throws std::runtime_error with the line and the fault.
std::string readCollada(const std::filesystem::path& file);

}  // namespace pongsim::assets
