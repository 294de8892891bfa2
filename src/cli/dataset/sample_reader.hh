#pragma once

#include <filesystem>
#include <vector>

#include "cli/dataset/sample.hh"
#include "pongsim/diagnostic.hh"

namespace pongsim::cli {

/// Reads what a segmentation or bounding-box camera has saved (docs/sensors.md).
/// @param folder The `<path>` of its `<save>`: with the folder images, and labels_maps or boxes.
/// @param diagnostics Errors: the folder has no samples. Warnings: pictures that are left out, because their labels are
/// missing or can't be read.
/// @return In the order of their numbers.
std::vector<Sample> readSamples(const std::filesystem::path& folder, Diagnostics& diagnostics);

}  // namespace pongsim::cli
