#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pongsim/outcome.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/sensing/camera_settings.hh"

namespace pongsim {

/// How a lens maps angles from the line of sight to distances from the middle of the image, in halves of its width:
///   r = c1 f fun(angle / c2 + c3),
/// see Kannala and Brandt, "A generic camera model and calibration method for conventional, wide-angle, and fish-eye
/// lenses" (2006).
class LensFunction {
 public:
  /// @return The function; or why there is none: "shows nothing ...".
  static Outcome<LensFunction> of(const LensSettings& settings, double horizontalFov);

  /// @param angle [rad]
  double radius(double angle) const;
  /// @return The angle that a lens shows there [rad]; nothing if it shows none.
  std::optional<double> angle(double radius) const;
  /// @return The largest radius up to an angle; infinite if it has no bound.
  double largestRadius(double angle) const;
  /// @return The slope of the radius at the line of sight [1/rad].
  double slope() const;

 private:
  LensFunction() = default;
  LensSettings::Custom terms_;
};

/// An image through a wide-angle lens: six pictures all around, from which each pixel takes what its line of sight
/// hits.
class WideLens {
 public:
  /// Longest edge of one of the six pictures [pixels].
  static constexpr long long kLongestEdge = 4000;

  /// @param function Of the lens.
  /// @param view Of the image; its focal length and centre have no effect.
  WideLens(const LensFunction& function, const LensSettings& settings, const PictureView& view);

  /// @param pixels Three bytes each; black beyond the cut-off angle.
  void draw(CameraScene& scene, const Pose& X_WorldEye, std::span<std::uint8_t> pixels);

 private:
  /// Where a pixel's line of sight hits one of the six pictures.
  struct Sample {
    /// Index of the picture; -1: none, the pixel is black.
    std::int32_t face = -1;
    /// From the left and the top [pixels].
    float column = 0;
    float row = 0;
    /// Less than 1 near the cut-off angle.
    float brightness = 1;
  };
  Sample sampleAt(const Vector3& direction) const;

  PictureView faceView_;
  std::vector<Sample> samples_;
  /// Empty: no pixel needs it.
  std::array<std::vector<std::uint8_t>, 6> faces_;
};

}  // namespace pongsim
