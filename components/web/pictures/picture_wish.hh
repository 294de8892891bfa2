#pragma once

#include <cstdint>

#include <nlohmann/json_fwd.hpp>

#include "pongsim/outcome.hh"
#include "pongsim/sensing/camera_scene.hh"

namespace pongsim::web {

inline constexpr std::uint32_t kShortestEdge = 16;
inline constexpr std::uint32_t kLongestEdge = 1280;

/// Reads what a page wants to see: {"pose": [x, y, z, qx, qy, qz, qw], "fieldOfView": vertical angle [rad], "width",
/// "height", "grid"}. The pose looks along x with z up; edges are between the limits above.
Outcome<PictureView> readPictureWish(const nlohmann::json& wish);

}  // namespace pongsim::web
