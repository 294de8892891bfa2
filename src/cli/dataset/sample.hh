#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "pongsim/types.hh"

namespace pongsim::cli {

/// The pixels that show something, as COCO stores them.
struct Mask {
  /// Numbers of pixels in turns, beginning with those that don't show it; column by column from the left, each from the
  /// top.
  std::vector<std::uint64_t> runs;
  /// How many show it.
  std::uint64_t area = 0;
};

/// A box in space, in the frame of renderers' cameras: x to the right, y up, z backwards.
struct BoxInSpace {
  /// Of its centre.
  Pose X_CameraBox;
  /// Side lengths [m].
  Vector3 size;
};

/// Something with a label in a picture.
struct LabelledThing {
  int label = 0;
  /// In the picture, from the left and upper edge of the first pixel that it covers to the right and lower edge of the
  /// last one [pixels].
  Eigen::AlignedBox2d box = {};
  /// From a segmentation camera.
  std::optional<Mask> mask = std::nullopt;
  /// Whether it may be several instances with the same label.
  bool isCrowd = false;
  /// From a camera with boxes in space.
  std::optional<BoxInSpace> space = std::nullopt;
};

/// A picture that a sensor has saved, and what is in it.
struct Sample {
  std::filesystem::path picture;
  /// [pixels]
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<LabelledThing> things;
};

}  // namespace pongsim::cli
