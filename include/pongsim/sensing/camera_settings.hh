#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "pongsim/sensing/noise_settings.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Content of a pixel: brightness in bits (`kL`), colours in this order, a distance [m], or one colour of a Bayer
/// pattern.
enum class PixelFormat {
  kL8,
  kL16,
  kR8G8B8,
  kB8G8R8,
  kRFloat16,
  kRFloat32,
  kBayerRggb8,
  kBayerBggr8,
  kBayerGbrg8,
  kBayerGrbg8
};

/// Nearest and farthest visible distance along the line of sight [m].
struct ClipSettings {
  double near = 0.1;
  double far = 100;
  bool operator==(const ClipSettings&) const = default;
};

/// `<distortion>`: Brown's model.
struct DistortionSettings {
  /// Radial.
  double k1 = 0;
  double k2 = 0;
  double k3 = 0;
  /// Tangential.
  double p1 = 0;
  double p2 = 0;
  /// As fractions of the image size.
  Eigen::Vector2d center{0.5, 0.5};
  bool operator==(const DistortionSettings&) const = default;
};

/// `<lens>`
struct LensSettings {
  /// How an angle from the line of sight maps to a distance in the image.
  enum class Type { kGnomonical, kStereographic, kEquidistant, kEquisolidAngle, kOrthographic, kCustom };
  enum class Function { kSin, kTan, kId };
  /// With `kCustom`: r = c1 f fun(angle / c2 + c3).
  struct Custom {
    double c1 = 1;
    double c2 = 1;
    /// [rad]
    double c3 = 0;
    double f = 1;
    Function function = Function::kTan;
    bool operator==(const Custom&) const = default;
  };
  /// `<intrinsics>`: focal lengths, principal point and skew [pixels].
  struct Intrinsics {
    double fx = 277;
    double fy = 277;
    double cx = 160;
    double cy = 120;
    double skew = 0;
    bool operator==(const Intrinsics&) const = default;
  };
  /// `<projection>`: the same for the rectified image, and a translation [pixels].
  struct Projection {
    double fx = 277;
    double fy = 277;
    double cx = 160;
    double cy = 120;
    double tx = 0;
    double ty = 0;
    bool operator==(const Projection&) const = default;
  };

  Type type = Type::kStereographic;
  bool scalesToHorizontalFov = true;
  Custom custom;
  /// Everything farther from the line of sight is invisible [rad].
  double cutoffAngle = 1.5707;
  /// Edge of each of the six images that it is stitched from [pixels].
  long long environmentTextureSize = 256;
  std::optional<Intrinsics> intrinsics;
  std::optional<Projection> projection;
  bool operator==(const LensSettings&) const = default;
};

/// What the system `thermal-sensor` in a thermal camera sets.
struct ThermalSettings {
  /// Temperature per unit of the image [K]; unset: 0.01 with 16 bits for each pixel, 3 with 8 bits.
  std::optional<double> resolution;
  /// Temperatures outside of these are shown as these [K].
  double coldest = 0;
  double hottest = std::numeric_limits<double>::infinity();
  bool operator==(const ThermalSettings&) const = default;
};

/// `<camera>`, for all types of cameras.
struct CameraSettings {
  enum class Segmentation { kSemantic, kPanoptic };
  enum class Boxes { kVisible2d, kFull2d, k3d };

  std::string name;
  /// Pose of the camera in the sensor's frame; it looks along x with z up.
  Pose X_SensorCamera;
  /// [rad]
  double horizontalFov = 1.047;
  /// [pixels]
  std::uint32_t width = 320;
  std::uint32_t height = 240;
  PixelFormat format = PixelFormat::kR8G8B8;
  /// Samples per pixel; 0: one.
  std::uint32_t antiAliasing = 4;
  ClipSettings clip;
  /// Range of the depth camera; unset: like `clip`.
  std::optional<ClipSettings> depthClip;
  /// `<depth_camera><output>`: "depths" or "points".
  std::string depthOutput = "depths";
  std::optional<DistortionSettings> distortion;
  /// Unset: a pinhole camera.
  std::optional<LensSettings> lens;
  /// For each colour of each pixel, as a fraction of the maximum.
  NoiseSettings noise;
  /// Visuals that share a bit with their visibility flags are visible.
  std::uint32_t visibilityMask = 0xFFFFFFFF;
  /// Takes images only when a message arrives on the topic.
  bool isTriggered = false;
  std::string triggerTopic;
  /// Empty: the default.
  std::string infoTopic;
  /// Frame name in camera infos; empty: that of the sensor.
  std::string opticalFrame;
  /// Writes images into this folder.
  bool savesPictures = false;
  std::string savePath;
  Segmentation segmentation = Segmentation::kSemantic;
  Boxes boxes = Boxes::kVisible2d;
  ThermalSettings thermal;
  bool operator==(const CameraSettings&) const = default;
};

}  // namespace pongsim
