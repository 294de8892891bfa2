#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "pongsim/noise_settings.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// What a pixel holds: brightness in bits (`kL`), colours in this order, a distance [m], or one colour of a Bayer
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

/// Distances along the line of sight between which a camera sees [m].
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
  /// In shares of the picture.
  Eigen::Vector2d center{0.5, 0.5};
  bool operator==(const DistortionSettings&) const = default;
};

/// `<lens>`
struct LensSettings {
  /// How an angle to the line of sight becomes a distance in the picture.
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
  /// `<projection>`: the same of the rectified picture, and a translation [pixels].
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
  /// What is farther from the line of sight is not seen [rad].
  double cutoffAngle = 1.5707;
  /// Edge of each of the six pictures that it is put together from [pixels].
  long long environmentTextureSize = 256;
  std::optional<Intrinsics> intrinsics;
  std::optional<Projection> projection;
  bool operator==(const LensSettings&) const = default;
};

/// `<camera>`, of every type of camera.
struct CameraSettings {
  enum class Segmentation { kSemantic, kPanoptic };
  enum class Boxes { kVisible2d, kFull2d, k3d };

  std::string name;
  /// Pose of the eye, which looks along x with z up, in the sensor's frame.
  Pose X_SensorCamera;
  /// [rad]
  double horizontalFov = 1.047;
  /// [pixels]
  std::uint32_t width = 320;
  std::uint32_t height = 240;
  PixelFormat format = PixelFormat::kR8G8B8;
  /// Samples a pixel; 0: one.
  std::uint32_t antiAliasing = 4;
  ClipSettings clip;
  /// What the depth camera measures; without one, as `clip`.
  std::optional<ClipSettings> depthClip;
  /// `<depth_camera><output>`: "depths" or "points".
  std::string depthOutput = "depths";
  std::optional<DistortionSettings> distortion;
  /// Without one: a pinhole.
  std::optional<LensSettings> lens;
  /// Of each colour of each pixel, in shares of the brightest.
  NoiseSettings noise;
  /// It sees what has one of these bits in its visibility flags.
  std::uint32_t visibilityMask = 0xFFFFFFFF;
  /// It takes a picture only when a message comes on that topic.
  bool isTriggered = false;
  std::string triggerTopic;
  /// Empty: the one by default.
  std::string infoTopic;
  /// Name of its frame in camera infos; empty: that of the sensor.
  std::string opticalFrame;
  /// Pictures are written into this folder.
  bool savesPictures = false;
  std::string savePath;
  Segmentation segmentation = Segmentation::kSemantic;
  Boxes boxes = Boxes::kVisible2d;
  bool operator==(const CameraSettings&) const = default;
};

}  // namespace pongsim
