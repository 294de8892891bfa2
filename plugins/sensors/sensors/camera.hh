#pragma once

#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "camera_lens.hh"
#include "pongsim/bulk.hh"
#include "pongsim/node.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/sensing/noise_set.hh"
#include "pongsim/sensing/sensor.hh"
#include "surroundings.hh"

namespace pongsim {

/// What the cameras of a world share.
class CameraSurroundings : public Surroundings<CameraScene> {
 public:
  /// @param plugin May give colours in place of those of the world's `<scene>`.
  CameraSurroundings(const World& world, Node& node, const Element& plugin);
};

/// One camera, of colours, of depths or of both: a sensor of a `SensorSystem`.
class CameraSensor {
 public:
  using Message = ignition::msgs::Image;
  using Shared = CameraSurroundings;
  static constexpr const char* kTypes[] = {"camera", "depth_camera", "depth", "rgbd_camera", "rgbd"};
  static constexpr const char* kSuffix = "/image";
  static constexpr const char* kText = "Publishes what the world's cameras see: colours, depths, points.";

  /// Of the topic by default.
  static const char* suffix(const Sensor& sensor);
  /// Behind the topic, where images are published.
  static const char* behindTopic(const Sensor& sensor);

  /// @throws Error where it can't be had: it has too many pixels, or there is nothing to draw with.
  CameraSensor(const Sensor& sensor, const World& world, NoiseSet& noises, Message& message,
               CameraSurroundings& shared);

  /// @return Whether it takes a picture now: always, unless it waits for a message first or has no power.
  bool isReady();
  /// @param isHeard Somebody listens to the images.
  void measure(Message& message, bool isHeard);
  /// @return The pixels that were measured, as the message has them. A picture that has no need of more is drawn where
  /// the first listener wants it, when he does.
  Bulk bulk();
  bool isHeardElsewhere() const;
  /// Publishes and saves what `measure` has measured.
  void publishElsewhere(const Message& message);
  void reset();
  void transfer(StateArchive& archive);

 private:
  enum class Kind { kColors, kDepths, kBoth };
  /// Of the picture of now: it is to be drawn; the first listener alone has it; it is in `colors_` where it is
  /// anywhere.
  enum class Drawing { kDue, kSent, kDone };
  static Kind kindOf(const Sensor& sensor);

  void beginMessages(Message& message);
  void listenToTrigger(Node& node);
  bool isDepthHeard() const { return depthImages_ && depthImages_.hasSubscribers(); }
  bool arePointsHeard() const { return points_ && points_.hasSubscribers(); }
  bool isDrawnAsItIsSent() const;
  void drawColors();
  void drawDepths();
  void writeColors(std::span<std::byte> to);
  Bulk depthBulk() const;
  /// @param right, down Slopes of the line of sight of the pixel.
  /// @return The point of the cloud; minus infinity where it is too near, infinity where nothing is.
  Eigen::Vector3f placeOf(std::size_t pixel, double right, double down) const;
  void writePoints(std::span<std::byte> to) const;
  void save();

  Sensor sensor_;
  CameraSettings settings_;
  Kind kind_;
  CameraSurroundings& surroundings_;
  Noise& noise_;
  /// In metres; of its own, so that depths do not depend on whether colours are drawn.
  Noise& depthNoise_;
  /// Of colours and of depths, which may have other clip planes.
  PictureView view_;
  PictureView depthView_;
  std::optional<Distortion> distortion_;
  std::vector<std::uint8_t> colors_;
  Drawing drawing_ = Drawing::kDone;
  /// How often the pixels of now have been written.
  int writes_ = 0;
  bool arePointsMeasured_ = false;
  /// Before it is distorted.
  std::vector<std::uint8_t> drawn_;
  std::vector<float> depths_;
  /// What noise has added to each of them [m]; empty: there is none.
  std::vector<float> shifts_;
  Publisher infos_;
  Publisher depthImages_;
  Publisher points_;
  Subscription trigger_;
  bool isTriggered_ = false;
  std::uint64_t savedCount_ = 0;
  ignition::msgs::CameraInfo info_;
  ignition::msgs::Image depthImage_;
  ignition::msgs::PointCloudPacked cloud_;
};

}  // namespace pongsim
