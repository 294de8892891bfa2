#pragma once

#include <string>

#include "cli/dataset/coco.hh"
#include "cli/dataset/sample.hh"

namespace pongsim::cli {

/// @param focalLength Of the camera, in pixels; for boxes in space, which it projects.
/// @return A line for each thing, in the format of KITTI's object benchmark (Geiger et al., 2012; its
/// devkit_object/readme.txt). What is unknown has the values that the benchmark has for that.
std::string kittiLabels(const Sample& sample, double focalLength, const LabelNames& names);

/// @return The projection of such a camera, as in KITTI's calib files.
std::string kittiCalibration(const Sample& sample, double focalLength);

}  // namespace pongsim::cli
