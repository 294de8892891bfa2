#pragma once

#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/types.hh"

namespace pongsim::rendering {

/// From places seen from the eye, in the axes of the world, to OpenGL's clip space with depths from 1, near, to 0, far:
/// so single precision tells far surfaces apart. The picture's top row is OpenGL's lowest, as images are stored.
Eigen::Matrix4d clipFromPlace(const PictureView& view);

/// Of what is seen at the clip coordinates x and y, in the axes of the world:
/// `directionFromClip(view) * (x, y, 1)`, of any length.
Matrix3 directionFromClip(const PictureView& view);

/// @return Whether a ball may be seen through a projection.
/// @param middle Seen from the eye.
bool mayBeSeen(const Eigen::Matrix4d& clipFromPlace, const Vector3& middle, double radius);

}  // namespace pongsim::rendering
