#pragma once

#include <string_view>

namespace pongsim::assets {

/// Checks what Assimp 5.2 does not check in a glTF file: it allocates as many bytes as a header claims, and follows
/// nodes recursively, also in circles.
/// @param content A .glb file or the JSON of a .gltf file.
/// @throws std::runtime_error with the fault.
void checkGltf(std::string_view content);

}  // namespace pongsim::assets
