#pragma once

#include <vector>

#include "assets/images/picture_file.hh"
#include "cli/dataset/sample.hh"

namespace pongsim::cli {

/// @param map What a segmentation camera saves in labels_maps: of a semantic camera the label in all three colours, of
/// a panoptic one the instance's number modulo 256, divided by 256, and its label.
/// @return The instances, or of a semantic camera all with a label as one crowd, by label and instance.
std::vector<LabelledThing> thingsIn(const assets::Picture& map);

}  // namespace pongsim::cli
