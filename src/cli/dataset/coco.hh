#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "cli/dataset/sample.hh"

namespace pongsim::cli {

/// What labels are called; those that are missing by their number.
using LabelNames = std::map<int, std::string>;

/// @return The name of a label.
std::string nameOf(int label, const LabelNames& names);

/// @param folder Of the file: pictures are named relative to it.
/// @return The samples in COCO's format for detection and segmentation, JSON (https://cocodataset.org/#format-data):
/// `bbox` from the left upper corner, masks in run lengths. Categories have the labels as their ids.
std::string cocoOf(std::span<const Sample> samples, const std::filesystem::path& folder, const LabelNames& names);

}  // namespace pongsim::cli
