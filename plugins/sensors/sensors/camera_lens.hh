#pragma once

#include <ignition/msgs/camera_info.pb.h>

#include <cstdint>
#include <span>
#include <vector>

#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/sensing/camera_settings.hh"

namespace pongsim {

/// @return How a camera looks, but for where it is: by `<lens><intrinsics>`, else by its field of view.
PictureView viewOf(const CameraSettings& settings);

/// Fills in what `camera_info` says of a view, all but the header.
void fillIn(const CameraSettings& settings, const PictureView& view, ignition::msgs::CameraInfo& info);

/// `<distortion>`: Brown's model, "Decentering distortion of lenses" (1966): what a pinhole sees at (x, y), in focal
/// lengths from the centre of the distortion, the lens shows at
///   x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2), and y likewise.
class Distortion {
 public:
  /// @param view Of the picture as it is to be.
  Distortion(const DistortionSettings& settings, const PictureView& view);

  /// @return What is to be drawn: wider than the picture where that shows more.
  const PictureView& source() const { return source_; }

  /// @param drawn The pixels of `source`.
  /// @param pixels Of the picture, black where the lens shows what is too far aside to be drawn.
  void apply(std::span<const std::uint8_t> drawn, std::span<std::uint8_t> pixels) const;

 private:
  PictureView source_;
  /// Where each pixel of the picture is found among the drawn ones, from the left and the top; not a number: nowhere.
  std::vector<Eigen::Vector2f> places_;
};

}  // namespace pongsim
