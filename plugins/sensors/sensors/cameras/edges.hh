#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pongsim/sensing/camera_scene.hh"

namespace pongsim {

// Boxes as lines in images. Each edge is two ends in pixels, from the left and the top.

/// Adds the edges of a box.
void addEdges(const Eigen::AlignedBox2d& box, std::vector<Eigen::Vector2d>& edges);

/// Adds the edges of a box, projected; none if a corner of it is behind the camera, as in Fortress.
/// @param box In the frame with x to the right, y up, and z backwards.
void addEdges(const TurnedBox& box, const PictureView& view, std::vector<Eigen::Vector2d>& edges);

/// Draws edges in green, one pixel wide; what is outside of the image is left out.
/// @param pixels Three bytes each.
void drawEdges(std::span<const Eigen::Vector2d> edges, std::uint32_t width, std::uint32_t height,
               std::span<std::uint8_t> pixels);

}  // namespace pongsim
