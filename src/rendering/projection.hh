#pragma once

#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/types.hh"

namespace pongsim::rendering {

/// From positions relative to the camera, along the world's axes, to OpenGL's clip space with depths from 1, near, to
/// 0, far, so that single precision resolves distant surfaces. The top row of the image is OpenGL's lowest, because
/// that is how images are stored.
Eigen::Matrix4d clipFromPlace(const PictureView& view);

/// The viewing direction at the clip coordinates x and y, along the world's axes: `directionFromClip(view) * (x, y,
/// 1)`, not normalized.
Matrix3 directionFromClip(const PictureView& view);

/// @return Whether a sphere may be visible through a projection.
/// @param middle Relative to the camera.
bool mayBeSeen(const Eigen::Matrix4d& clipFromPlace, const Vector3& middle, double radius);

}  // namespace pongsim::rendering
