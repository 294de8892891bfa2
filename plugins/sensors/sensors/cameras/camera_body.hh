#pragma once

#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/header.pb.h>
#include <ignition/msgs/image.pb.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "pongsim/node.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/sensing/camera_settings.hh"
#include "pongsim/sensing/sensor_system.hh"
#include "surroundings.hh"
#include "wide_lens.hh"

namespace pongsim {

/// What the cameras of a world share.
using CameraSurroundings = Surroundings<CameraScene>;

/// Fills in what is the same in all images of a camera, except the header. The pixels are its bulk.
void beginImage(std::uint32_t width, std::uint32_t height, ignition::msgs::PixelFormatType type, std::uint32_t bytes,
                ignition::msgs::Image& image);

/// What cameras of all kinds have in common: power, trigger, projection, `camera_info` and saved files.
class CameraBody {
 public:
  /// Whether `camera_info` is beside or below the camera's topic.
  enum class InfoPlace { kBeside, kBelow };

  /// @throws Error if its settings are not supported, or it has too many pixels.
  CameraBody(const SensorContext& context, CameraSurroundings& surroundings, InfoPlace infoPlace);

  /// @return Those of the file, without a noise that cameras do not support; nothing is nearer than `clip.near`.
  const CameraSettings& settings() const { return settings_; }
  const Sensor& sensor() const { return sensor_; }
  /// @return An error about this camera: "camera 'm::l::s' has ...".
  Error error(const std::string& what, const std::string& hint = {}) const;

  /// @return Whether it takes an image now. It does not while it waits for a trigger, or has no power.
  bool isReady();
  /// @return For a camera with a wide angle its lens, else nothing.
  const std::optional<LensFunction>& wideLens() const { return wideLens_; }
  /// @return Its projection at its current pose.
  PictureView view() const;
  /// @return Its pose in the world.
  Pose pose() const { return sensor_.pose() * settings_.X_SensorCamera; }
  /// @return What it sees now.
  CameraScene& scene() const { return surroundings_.now(); }
  std::size_t pixelCount() const { return std::size_t{settings_.width} * settings_.height; }

  bool isInfoHeard() const { return infos_.hasSubscribers(); }
  /// @param header Of the image that it belongs to.
  void publishInfo(const ignition::msgs::Header& header);

  bool saves() const { return settings_.savesPictures; }
  /// Writes files of an image. Where that fails, it says so and saves no more.
  /// @param write Is called with `<path>`, which exists by then, and the number of the image.
  void save(const std::function<void(const std::filesystem::path& folder, std::uint64_t number)>& write);
  /// Sets the number of the first saved image.
  void beginSavingAt(std::uint64_t number) { firstSaved_ = savedCount_ = number; }

  void reset();
  void transfer(StateArchive& archive);

 private:
  void useWideLens();
  void listenToTrigger(Node& node);

  Sensor sensor_;
  CameraSettings settings_;
  CameraSurroundings& surroundings_;
  PictureView view_;
  std::optional<LensFunction> wideLens_;
  Publisher infos_;
  ignition::msgs::CameraInfo info_;
  Subscription trigger_;
  bool isTriggered_ = false;
  std::uint64_t firstSaved_ = 0;
  std::uint64_t savedCount_ = 0;
};

/// A camera with a message. A derived class implements the measurement.
template <class Message>
class CameraOf : public SensorOf<Message> {
 public:
  bool isReady() final { return body_.isReady(); }
  void reset() final { body_.reset(); }
  void transfer(StateArchive& archive) final { body_.transfer(archive); }

 protected:
  /// @throws Error like `CameraBody`.
  CameraOf(const SensorContext& context, CameraSurroundings& surroundings, CameraBody::InfoPlace infoPlace)
      : SensorOf<Message>(context), body_(context, surroundings, infoPlace) {}

  CameraBody body_;
};

}  // namespace pongsim
