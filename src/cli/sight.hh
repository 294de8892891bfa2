#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pongsim/camera_scene.hh"
#include "pongsim/types.hh"

namespace pongsim::cli {

/// What `pongsim view` draws: a world as it stands, wherever it comes from.
class Sight {
 public:
  virtual ~Sight() = default;

  /// @return The models that may be looked at: "outer::inner".
  virtual std::vector<std::string> models() = 0;

  /// As `CameraScene::bounds`.
  /// @param model One of `models`; empty: all of them.
  virtual Eigen::AlignedBox3d bounds(const std::string& model) = 0;

  /// As `CameraScene::drawColors`.
  virtual void draw(const PictureView& view, std::span<std::uint8_t> pixels) = 0;
};

}  // namespace pongsim::cli
