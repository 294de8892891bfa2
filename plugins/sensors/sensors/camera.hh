#pragma once

#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "camera_lens.hh"
#include "cameras/camera_body.hh"
#include "pongsim/bulk.hh"
#include "pongsim/node.hh"
#include "pongsim/sensing/noise.hh"
#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

/// One camera for colours, depths or both.
class CameraSensor final : public CameraOf<ignition::msgs::Image> {
 public:
  /// @throws Error if its settings are not supported, or it has too many pixels.
  CameraSensor(const SensorContext& context, CameraSurroundings& surroundings);

  void measure() override;
  /// @return The pixels as in the message. An image that needs no processing is rendered directly into the first
  /// subscriber's buffer, when that asks for it.
  std::optional<Bulk> bulk() override;
  bool isHeardElsewhere() const override;
  /// Publishes and saves what `measure` has measured.
  void publishElsewhere() override;

 private:
  enum class Kind { kColors, kDepths, kBoth };
  /// State of the current image: not rendered yet; rendered into the first subscriber's buffer only; in `colors_`, if
  /// anywhere.
  enum class Drawing { kDue, kSent, kDone };
  static Kind kindOf(const Sensor& sensor);

  void beginMessages();
  bool isDepthHeard() const { return depthImages_ && depthImages_.hasSubscribers(); }
  bool arePointsHeard() const { return points_ && points_.hasSubscribers(); }
  bool isDrawnAsItIsSent() const;
  void drawColors();
  void drawDepths();
  void writeColors(std::span<std::byte> to);
  Bulk depthBulk() const;
  /// @param right, down Slopes of the pixel's line of sight.
  /// @return The point of the cloud; minus infinity if it is too near, infinity if there is none.
  Eigen::Vector3f placeOf(std::size_t pixel, double right, double down) const;
  void writePoints(std::span<std::byte> to) const;

  Kind kind_;
  const CameraSettings& settings_;
  const SensorTopic& topic_;
  Noise& noise_;
  /// In metres. A stream of its own, so that depths do not depend on whether colours are rendered.
  Noise& depthNoise_;
  /// For colours and for depths, which may have other clip planes.
  PictureView view_;
  PictureView depthView_;
  std::optional<Distortion> distortion_;
  std::optional<WideLens> wideLens_;
  std::vector<std::uint8_t> colors_;
  Drawing drawing_ = Drawing::kDone;
  /// How often the pixels of the current image have been written.
  int writes_ = 0;
  bool arePointsMeasured_ = false;
  /// Before distortion.
  std::vector<std::uint8_t> drawn_;
  std::vector<float> depths_;
  /// Noise added to each depth [m]; empty without noise.
  std::vector<float> shifts_;
  Publisher depthImages_;
  Publisher points_;
  ignition::msgs::Image depthImage_;
  ignition::msgs::PointCloudPacked cloud_;
};

}  // namespace pongsim
