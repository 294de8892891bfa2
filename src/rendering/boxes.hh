#pragma once

#include <cstddef>
#include <span>

#include "pongsim/sensing/camera_scene.hh"
#include "rendering/scene.hh"

namespace pongsim::rendering {

/// See `CameraScene::imageBounds`.
Eigen::AlignedBox2d imageBounds(const Scene& scene, std::size_t visual, const PictureView& view);

/// See `CameraScene::turnedBox`.
TurnedBox turnedBox(const Scene& scene, std::span<const std::size_t> visuals);

}  // namespace pongsim::rendering
