#pragma once

#include <string>

#include "assets/figures/skeleton.hh"

namespace pongsim::assets {

/// Reads a motion from the content of a BVH file (Meredith and Maddock, "Motion Capture File Formats Explained", 2001)
/// for the bones of a skin. As in Fortress, both hierarchies must have the same form; the names of bones have no
/// effect. The bones are as long as those of the file, and turned so that they rest in the directions of the skin's.
/// @param scale Metres per unit of the file.
/// @return In the skin's units, by the names of its bones.
/// @throws std::runtime_error with the line and the fault.
Motion bvhMotion(const std::string& content, double scale, const Skeleton& skin);

}  // namespace pongsim::assets
