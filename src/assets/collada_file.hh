#pragma once

#include <filesystem>
#include <string>

namespace pongsim::assets {

/// Reads a Collada file for Assimp, whose reader trusts what is in it.
/// @return Its XML without what isn't used, such as animations, weights of skins, lines and embedded images; checked.
/// @throws std::runtime_error with the line and the fault.
std::string readCollada(const std::filesystem::path& file);

}  // namespace pongsim::assets
