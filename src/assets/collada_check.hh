#pragma once

namespace tinyxml2 {
class XMLElement;
}

namespace pongsim::assets {

/// Checks in a Collada file what Assimp 5.2 doesn't: it reads past the end of arrays, reserves memory for as many
/// values as a file says there are, and never returns from text among indices or from references in a circle.
/// @throws std::runtime_error with the line and the fault.
void checkCollada(const tinyxml2::XMLElement& collada);

}  // namespace pongsim::assets
