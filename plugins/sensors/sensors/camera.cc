#include "camera.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <exception>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

#include "point_cloud.hh"
#include "pongsim/log.hh"
#include "pongsim/messages/fields.hh"

namespace pongsim {

namespace {

using ignition::msgs::PointCloudPacked;

// gives an image message of 48 MB
constexpr std::uint64_t kMostPixels = 16'000'000;
// nothing closer is rendered, whatever <near> is [m]
constexpr double kNearestClip = 1e-3;
constexpr std::uint32_t kColorOffset = 16;
/// As in Fortress.
constexpr PointField kCameraPointFields[] = {{"x", 0, PointCloudPacked::Field::FLOAT32},
                                             {"y", 4, PointCloudPacked::Field::FLOAT32},
                                             {"z", 8, PointCloudPacked::Field::FLOAT32},
                                             {"rgb", kColorOffset, PointCloudPacked::Field::FLOAT32}};

/// Fortress's names of the formats of colour cameras, and their bytes per pixel.
struct ImageFormat {
  PixelFormat format;
  ignition::msgs::PixelFormatType type;
  std::uint32_t bytes;
};
constexpr ImageFormat kImageFormats[] = {{PixelFormat::kR8G8B8, ignition::msgs::RGB_INT8, 3},
                                         {PixelFormat::kB8G8R8, ignition::msgs::BGR_INT8, 3},
                                         {PixelFormat::kL8, ignition::msgs::L_INT8, 1},
                                         {PixelFormat::kL16, ignition::msgs::L_INT16, 2}};

const ImageFormat* imageFormat(PixelFormat format) {
  const auto* found = std::ranges::find(kImageFormats, format, &ImageFormat::format);
  return found == std::end(kImageFormats) ? nullptr : found;
}

Error errorOf(const Sensor& sensor, const std::string& what, const std::string& hint) {
  return Error({Severity::kError, sensor.sdf().position, "camera '" + sensor.scopedName() + "' " + what, hint});
}

/// @return The camera's settings, without noise types that cameras do not support; a warning reports these.
CameraSettings usedSettings(const Sensor& sensor) {
  CameraSettings settings = *sensor.settings<CameraSettings>();
  if (settings.noise.type == NoiseSettings::Type::kGaussianQuantized) settings.noise = {};
  return settings;
}

/// @return The default topic of `camera_info`: beside the images.
std::string infoTopic(const std::string& topic, bool isBelow) {
  if (isBelow) return topic + "/camera_info";
  const std::size_t slash = topic.rfind('/');
  return (slash == std::string::npos ? "" : topic.substr(0, slash)) + "/camera_info";
}

/// Brightness of a colour (ITU-R BT.601), from 0 to 255 or 65,535.
double brightness(const std::uint8_t* color, double most) {
  return (0.299 * color[0] + 0.587 * color[1] + 0.114 * color[2]) * most / 255;
}

void begin(std::uint32_t width, std::uint32_t height, ignition::msgs::PixelFormatType type, std::uint32_t bytes,
           ignition::msgs::Image& image) {
  image.set_width(width);
  image.set_height(height);
  image.set_step(width * bytes);
  image.set_pixel_format_type(type);
}

}  // namespace

CameraSensor::Kind CameraSensor::kindOf(const Sensor& sensor) {
  if (sensor.type() == "camera") return Kind::kColors;
  return sensor.type().starts_with("depth") ? Kind::kDepths : Kind::kBoth;
}

CameraSensor::CameraSensor(const SensorContext& context, CameraSurroundings& surroundings)
    : SensorOf(context),
      sensor_(context.sensor),
      settings_(usedSettings(sensor_)),
      kind_(kindOf(sensor_)),
      surroundings_(surroundings),
      topic_(context.topic),
      noise_(context.noises.add(settings_.noise, "image")),
      depthNoise_(context.noises.add(settings_.noise, "depth")) {
  if (std::uint64_t{settings_.width} * settings_.height > kMostPixels) {
    throw errorOf(sensor_, "has more than " + std::to_string(kMostPixels) + " pixels", {});
  }
  if (kind_ != Kind::kDepths && imageFormat(settings_.format) == nullptr) {
    throw errorOf(sensor_, "has an unsupported <format>", "use R8G8B8, B8G8R8, L8 or L16");
  }
  if (!settings_.lens.has_value() && settings_.horizontalFov >= 3.1) {
    throw errorOf(sensor_, "has a field of view too wide for a pinhole camera",
                  "<horizontal_fov> must be less than 3.1 rad");
  }
  if (settings_.savesPictures && settings_.savePath.empty()) {
    throw errorOf(sensor_, "saves images, but has no <path>", "write <save><path>FOLDER</path></save>");
  }
  settings_.clip.near = std::max(settings_.clip.near, kNearestClip);
  view_ = depthView_ = viewOf(settings_);
  if (settings_.depthClip) {
    depthView_.near = std::max(settings_.depthClip->near, kNearestClip);
    depthView_.far = settings_.depthClip->far;
  }
  if (settings_.distortion && kind_ == Kind::kColors) distortion_.emplace(*settings_.distortion, view_);

  infos_ = context.node.advertise<ignition::msgs::CameraInfo>(
      settings_.infoTopic.empty() ? infoTopic(topic_.name(), kind_ == Kind::kBoth) : cleanTopic(settings_.infoTopic));
  if (kind_ == Kind::kBoth) depthImages_ = context.advertise(SensorReadings::kDepth);
  if (kind_ != Kind::kColors) points_ = context.advertise(SensorReadings::kPoints);
  if (settings_.isTriggered) listenToTrigger(context.node);
  beginMessages();
}

void CameraSensor::beginMessages() {
  const std::uint32_t width = settings_.width, height = settings_.height;
  if (kind_ == Kind::kDepths) {
    begin(width, height, ignition::msgs::R_FLOAT32, sizeof(float), message());
  } else {
    const ImageFormat& format = *imageFormat(settings_.format);
    begin(width, height, format.type, format.bytes, message());
  }
  pongsim::fillIn(settings_, view_, info_);
  if (kind_ == Kind::kColors) return;
  if (kind_ == Kind::kBoth) begin(width, height, ignition::msgs::R_FLOAT32, sizeof(float), depthImage_);
  beginCloud(kCameraPointFields, width, height, cloud_);
}

void CameraSensor::listenToTrigger(Node& node) {
  if (settings_.triggerTopic.empty()) {
    throw errorOf(sensor_, "is triggered, but has no <trigger_topic>", "write <trigger_topic>TOPIC</trigger_topic>");
  }
  trigger_ = node.subscribe(cleanTopic(settings_.triggerTopic), "ignition.msgs.Boolean",
                            [this](const pongsim::Message&) { isTriggered_ = true; });
}

bool CameraSensor::isReady() {
  if (!surroundings_.hasPower(sensor_)) return false;
  if (!settings_.isTriggered) return true;
  const bool was = isTriggered_;
  isTriggered_ = false;
  return was;
}

bool CameraSensor::isHeardElsewhere() const {
  return infos_.hasSubscribers() || isDepthHeard() || arePointsHeard() || settings_.savesPictures;
}

/// @return Whether the rendered pixels need no processing, and at most one subscriber took the last image.
bool CameraSensor::isDrawnAsItIsSent() const {
  return settings_.format == PixelFormat::kR8G8B8 && settings_.noise.type == NoiseSettings::Type::kNone &&
         !distortion_ && !settings_.savesPictures && writes_ <= 1;
}

void CameraSensor::drawColors() {
  drawing_ = Drawing::kDone;
  colors_.resize(std::size_t{3} * settings_.width * settings_.height);
  if (distortion_) {
    PictureView source = distortion_->source();
    source.X_WorldEye = view_.X_WorldEye;
    drawn_.resize(std::size_t{3} * source.width * source.height);
    surroundings_.now().drawColors(source, drawn_);
    distortion_->apply(drawn_, colors_);
  } else {
    surroundings_.now().drawColors(view_, colors_);
  }
  if (settings_.noise.type == NoiseSettings::Type::kNone) return;
  for (std::uint8_t& value : colors_) {
    const double share = std::clamp(noise_.apply(value / 255.0), 0.0, 1.0);
    value = static_cast<std::uint8_t>(std::lround(share * 255));
  }
}

void CameraSensor::drawDepths() {
  depths_.resize(std::size_t{settings_.width} * settings_.height);
  surroundings_.now().drawDepths(depthView_, depths_);
  if (settings_.noise.type == NoiseSettings::Type::kNone) return;
  shifts_.assign(depths_.size(), 0);
  for (std::size_t i = 0; i < depths_.size(); ++i) {
    float& depth = depths_[i];
    if (!std::isfinite(depth)) continue;
    shifts_[i] = static_cast<float>(depthNoise_.apply(0));
    depth += shifts_[i];
    // as in Fortress, which clips again after adding noise
    if (depth >= static_cast<float>(depthView_.far)) depth = std::numeric_limits<float>::infinity();
    if (depth <= static_cast<float>(depthView_.near)) depth = -std::numeric_limits<float>::infinity();
  }
}

void CameraSensor::measure() {
  const bool isHeard = topic_.hasSubscribers();
  view_.X_WorldEye = depthView_.X_WorldEye = sensor_.pose() * settings_.X_SensorCamera;
  const bool ofDepths = kind_ == Kind::kDepths;
  arePointsMeasured_ = arePointsHeard();
  if (isHeard && !ofDepths && !arePointsMeasured_ && isDrawnAsItIsSent()) {
    drawing_ = Drawing::kDue;
  } else if ((isHeard && !ofDepths) || arePointsMeasured_ || settings_.savesPictures) {
    drawColors();
  }
  writes_ = 0;
  if ((isHeard && ofDepths) || isDepthHeard() || arePointsMeasured_) {
    drawDepths();
  }
}

Bulk CameraSensor::depthBulk() const {
  return {.size = std::size_t{settings_.width} * settings_.height * sizeof(float),
          .write = [this](std::span<std::byte> to) {
            // a new subscriber gets the previous depths, or none
            if (depths_.empty()) {
              std::ranges::fill(to, std::byte(0));
            } else {
              std::memcpy(to.data(), depths_.data(), to.size());
            }
          }};
}

std::optional<Bulk> CameraSensor::bulk() {
  if (kind_ == Kind::kDepths) return depthBulk();
  return Bulk{.size = std::size_t{settings_.width} * settings_.height * imageFormat(settings_.format)->bytes,
              .write = [this](std::span<std::byte> to) { writeColors(to); }};
}

void CameraSensor::writeColors(std::span<std::byte> place) {
  auto* to = reinterpret_cast<std::uint8_t*>(place.data());
  ++writes_;
  if (drawing_ == Drawing::kDue) {
    surroundings_.now().drawColors(view_, {to, place.size()});
    drawing_ = Drawing::kSent;
    return;
  }
  // render again: another subscriber wants the image, and the first one's buffer may have been reused
  if (drawing_ == Drawing::kSent) drawColors();
  // a new subscriber gets the previous image, or a black one
  if (colors_.empty()) {
    std::ranges::fill(place, std::byte(0));
    return;
  }
  if (settings_.format == PixelFormat::kR8G8B8) {
    // GCC 12 compiles std::ranges::copy to a loop over single bytes
    std::memcpy(to, colors_.data(), colors_.size());
    return;
  }
  for (std::size_t i = 0; i < colors_.size(); i += 3) {
    const std::uint8_t* color = &colors_[i];
    if (settings_.format == PixelFormat::kB8G8R8) {
      for (const int channel : {2, 1, 0}) *to++ = color[channel];
    } else if (settings_.format == PixelFormat::kL8) {
      *to++ = static_cast<std::uint8_t>(std::lround(brightness(color, 255)));
    } else {
      const auto value = static_cast<std::uint16_t>(std::lround(brightness(color, 65535)));
      std::memcpy(to, &value, sizeof(value));
      to += sizeof(value);
    }
  }
}

Eigen::Vector3f CameraSensor::placeOf(std::size_t pixel, double right, double down) const {
  const float depth = depths_[pixel];
  if (!std::isfinite(depth)) return Eigen::Vector3f::Constant(depth);
  // as in Fortress, the noise of the depth also changes y and z
  const double shift = shifts_.empty() ? 0 : static_cast<double>(shifts_[pixel]);
  const double ahead = static_cast<double>(depth) - shift;
  return {depth, static_cast<float>(shift - ahead * right), static_cast<float>(shift - ahead * down)};
}

void CameraSensor::writePoints(std::span<std::byte> to) const {
  std::byte* point = to.data();
  for (std::uint32_t row = 0; row < settings_.height; ++row) {
    const double down = (row + 0.5 - depthView_.cy) / depthView_.fy;
    for (std::uint32_t column = 0; column < settings_.width; ++column, point += kPointSize) {
      const std::size_t i = std::size_t{row} * settings_.width + column;
      const double right = (column + 0.5 - depthView_.cx - depthView_.skew * down) / depthView_.fx;
      const Eigen::Vector3f place = placeOf(i, right, down);
      std::memset(point, 0, kPointSize);
      std::memcpy(point, place.data(), sizeof(float) * 3);
      // blue first, as in Fortress
      const std::array<std::uint8_t, 4> color{colors_[3 * i + 2], colors_[3 * i + 1], colors_[3 * i], 0};
      std::memcpy(point + kColorOffset, color.data(), color.size());
    }
  }
}

void CameraSensor::publishElsewhere() {
  if (infos_.hasSubscribers()) {
    *info_.mutable_header() = message().header();
    if (!settings_.opticalFrame.empty()) {
      setHeaderValue("frame_id", settings_.opticalFrame, *info_.mutable_header());
    }
    infos_.publish(info_);
  }
  if (isDepthHeard()) {
    *depthImage_.mutable_header() = message().header();
    depthImages_.publish(depthImage_, depthBulk());
  }
  if (arePointsMeasured_) {
    *cloud_.mutable_header() = message().header();
    cloud_.set_is_dense(std::ranges::all_of(depths_, [](float depth) { return std::isfinite(depth); }));
    points_.publish(
        cloud_, {.size = depths_.size() * kPointSize, .write = [this](std::span<std::byte> to) { writePoints(to); }});
  }
  if (settings_.savesPictures) save();
}

void CameraSensor::save() {
  try {
    const std::filesystem::path folder = settings_.savePath;
    std::filesystem::create_directories(folder);
    const std::string name = std::string(sensor_.name()) + "_" + std::to_string(savedCount_++) + ".png";
    CameraScene::writePicture(folder / name, settings_.width, settings_.height, colors_);
  } catch (const std::exception& error) {
    Logger("sensors").warning("camera '" + sensor_.scopedName() + "' stopped saving images: " + error.what());
    settings_.savesPictures = false;
  }
}

void CameraSensor::reset() {
  isTriggered_ = false;
  savedCount_ = 0;
}

void CameraSensor::transfer(StateArchive& archive) {
  archive(isTriggered_);
  archive(savedCount_);
}

}  // namespace pongsim
