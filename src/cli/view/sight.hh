#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/types.hh"

namespace pongsim::cli {

/// The world that `pongsim view` draws, wherever it comes from.
class Sight {
 public:
  virtual ~Sight() = default;

  /// @return What can be looked at: models, "outer::inner", then actors.
  virtual std::vector<std::string> names() = 0;

  /// See `CameraScene::bounds`.
  /// @param name One of `names`; empty: all of them.
  virtual Eigen::AlignedBox3d bounds(const std::string& name) = 0;

  /// See `CameraScene::drawColors`.
  virtual void draw(const PictureView& view, std::span<std::uint8_t> pixels) = 0;
};

}  // namespace pongsim::cli
