#pragma once

#include <optional>
#include <string>

#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/types.hh"

namespace pongsim::cli {

/// @param text "x y z", or "x y z roll pitch yaw" [m, rad].
/// @return The pose; without angles it looks at the origin. Nothing if the text is invalid.
std::optional<Pose> readViewpoint(const std::string& text);

/// Places the camera so that a box fills the image, seen from the south-west and from above.
void lookAt(const Eigen::AlignedBox3d& box, PictureView& view);

}  // namespace pongsim::cli
