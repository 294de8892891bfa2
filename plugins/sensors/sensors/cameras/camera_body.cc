#include "camera_body.hh"

#include <algorithm>
#include <exception>

#include "camera_lens.hh"
#include "pongsim/log.hh"
#include "pongsim/messages/fields.hh"

namespace pongsim {

namespace {

// gives an image message of 48 MB
constexpr std::uint64_t kMostPixels = 16'000'000;
// nothing closer is rendered, whatever <near> is [m]
constexpr double kNearestClip = 1e-3;

CameraSettings usedSettings(const Sensor& sensor) {
  CameraSettings settings = *sensor.settings<CameraSettings>();
  // a warning has said so
  if (settings.noise.type == NoiseSettings::Type::kGaussianQuantized) settings.noise = {};
  settings.clip.near = std::max(settings.clip.near, kNearestClip);
  if (settings.depthClip) settings.depthClip->near = std::max(settings.depthClip->near, kNearestClip);
  return settings;
}

/// @return The default topic of `camera_info`.
std::string infoTopic(const std::string& topic, CameraBody::InfoPlace place) {
  if (place == CameraBody::InfoPlace::kBelow) return topic + "/camera_info";
  const std::size_t slash = topic.rfind('/');
  return (slash == std::string::npos ? "" : topic.substr(0, slash)) + "/camera_info";
}

}  // namespace

void beginImage(std::uint32_t width, std::uint32_t height, ignition::msgs::PixelFormatType type, std::uint32_t bytes,
                ignition::msgs::Image& image) {
  image.set_width(width);
  image.set_height(height);
  image.set_step(width * bytes);
  image.set_pixel_format_type(type);
}

CameraBody::CameraBody(const SensorContext& context, CameraSurroundings& surroundings, InfoPlace infoPlace)
    : sensor_(context.sensor), settings_(usedSettings(sensor_)), surroundings_(surroundings) {
  if (std::uint64_t{settings_.width} * settings_.height > kMostPixels) {
    throw error("has more than " + std::to_string(kMostPixels) + " pixels");
  }
  const bool isWideAngle = sensor_.type().starts_with("wide");
  if (isWideAngle && !settings_.lens) settings_.lens.emplace();
  if (!isWideAngle && !settings_.lens.has_value() && settings_.horizontalFov >= 3.1) {
    throw error("has a field of view too wide for a pinhole camera", "<horizontal_fov> must be less than 3.1 rad");
  }
  if (settings_.savesPictures && settings_.savePath.empty()) {
    throw error("saves images, but has no <path>", "write <save><path>FOLDER</path></save>");
  }
  view_ = viewOf(settings_);
  if (isWideAngle) useWideLens();
  infos_ = context.node.advertise<ignition::msgs::CameraInfo>(
      settings_.infoTopic.empty() ? infoTopic(context.topic.name(), infoPlace) : cleanTopic(settings_.infoTopic));
  fillIn(settings_, view_, info_);
  if (isWideAngle && settings_.lens->type == LensSettings::Type::kEquidistant) {
    info_.mutable_distortion()->set_model(ignition::msgs::CameraInfo::Distortion::EQUIDISTANT);
    // it has four coefficients, which are zero for the lens of this name
    info_.mutable_distortion()->mutable_k()->Truncate(4);
  }
  if (settings_.isTriggered) listenToTrigger(context.node);
}

Error CameraBody::error(const std::string& what, const std::string& hint) const {
  return Error({Severity::kError, sensor_.sdf().position, "camera '" + sensor_.scopedName() + "' " + what, hint});
}

/// Finds the lens, and makes the projection that of a pinhole that shows the same in the middle of the image.
void CameraBody::useWideLens() {
  if (settings_.lens->environmentTextureSize > WideLens::kLongestEdge) {
    throw error("has an <env_texture_size> above " + std::to_string(WideLens::kLongestEdge));
  }
  Outcome<LensFunction> lens = LensFunction::of(*settings_.lens, settings_.horizontalFov);
  if (!lens) throw error(lens.error);
  wideLens_ = *lens;
  view_.fx = view_.fy = wideLens_->slope() * view_.width / 2;
  view_.cx = view_.width / 2.0;
  view_.cy = view_.height / 2.0;
  view_.skew = 0;
}

void CameraBody::listenToTrigger(Node& node) {
  if (settings_.triggerTopic.empty()) {
    throw error("is triggered, but has no <trigger_topic>", "write <trigger_topic>TOPIC</trigger_topic>");
  }
  trigger_ = node.subscribe(cleanTopic(settings_.triggerTopic), "ignition.msgs.Boolean",
                            [this](const Message&) { isTriggered_ = true; });
}

bool CameraBody::isReady() {
  if (!surroundings_.hasPower(sensor_)) return false;
  if (!settings_.isTriggered) return true;
  const bool was = isTriggered_;
  isTriggered_ = false;
  return was;
}

PictureView CameraBody::view() const {
  PictureView view = view_;
  view.X_WorldEye = pose();
  return view;
}

void CameraBody::publishInfo(const ignition::msgs::Header& header) {
  if (!isInfoHeard()) return;
  *info_.mutable_header() = header;
  if (!settings_.opticalFrame.empty()) setHeaderValue("frame_id", settings_.opticalFrame, *info_.mutable_header());
  infos_.publish(info_);
}

void CameraBody::save(const std::function<void(const std::filesystem::path&, std::uint64_t)>& write) {
  if (!settings_.savesPictures) return;
  try {
    const std::filesystem::path folder = settings_.savePath;
    std::filesystem::create_directories(folder);
    write(folder, savedCount_++);
  } catch (const std::exception& error) {
    Logger("sensors").warning("camera '" + sensor_.scopedName() + "' stopped saving images: " + error.what());
    settings_.savesPictures = false;
  }
}

void CameraBody::reset() {
  isTriggered_ = false;
  savedCount_ = firstSaved_;
}

void CameraBody::transfer(StateArchive& archive) {
  archive(isTriggered_);
  archive(savedCount_);
}

}  // namespace pongsim
