#pragma once

#include <ignition/msgs/camera_info.pb.h>

#include <cstdint>
#include <span>
#include <vector>

#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/sensing/camera_settings.hh"

namespace pongsim {

/// @return The projection of a camera, without its pose: from `<lens><intrinsics>`, else from its field of view.
PictureView viewOf(const CameraSettings& settings);

/// Fills in `camera_info` for a view, except the header.
void fillIn(const CameraSettings& settings, const PictureView& view, ignition::msgs::CameraInfo& info);

/// `<distortion>`: Brown's model, "Decentering distortion of lenses" (1966): what a pinhole sees at (x, y), in focal
/// lengths from the centre of the distortion, the lens shows at
///   x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2), and y likewise.
class Distortion {
 public:
  /// @param view Of the distorted image.
  Distortion(const DistortionSettings& settings, const PictureView& view);

  /// @return The view to render: larger than the image if the lens shows more.
  const PictureView& source() const { return source_; }

  /// @param drawn The pixels of `source`.
  /// @param pixels Of the distorted image; black where the lens shows more than was rendered.
  void apply(std::span<const std::uint8_t> drawn, std::span<std::uint8_t> pixels) const;

 private:
  PictureView source_;
  /// For each pixel of the image, its position in the rendered image, from the left and the top; NaN if outside.
  std::vector<Eigen::Vector2f> places_;
};

}  // namespace pongsim
