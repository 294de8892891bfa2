#pragma once

namespace tinyxml2 {
class XMLElement;
}

namespace pongsim::assets {

/// Checks what Assimp 5.2 does not check in a Collada file: it reads past the end of arrays, allocates memory for as
/// many values as the file claims, and loops forever on text among indices and on cyclic references.
/// @throws std::runtime_error with the line and the fault.
void checkCollada(const tinyxml2::XMLElement& collada);

}  // namespace pongsim::assets
