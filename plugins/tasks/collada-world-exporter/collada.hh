#pragma once

#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "pongsim/appearance.hh"

namespace pongsim {

/// Writes parts and lights as a COLLADA 1.4.1 document, with z up and in metres. Part number i is the geometry "mesh_i"
/// in the node "node_i", as in Fortress; sizes are in the vertices, poses in the nodes.
/// @param textures File names of the textures in the document.
void writeCollada(const std::vector<VisiblePart>& parts, const std::vector<VisibleLight>& lights,
                  const std::map<std::filesystem::path, std::string>& textures, std::ostream& out);

}  // namespace pongsim
