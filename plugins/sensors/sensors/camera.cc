#include "camera.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
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

/// Brightness of a colour (ITU-R BT.601), from 0 to 255 or 65,535.
double brightness(const std::uint8_t* color, double most) {
  return (0.299 * color[0] + 0.587 * color[1] + 0.114 * color[2]) * most / 255;
}

}  // namespace

CameraSensor::Kind CameraSensor::kindOf(const Sensor& sensor) {
  if (sensor.type() == "camera" || sensor.type().starts_with("wide")) return Kind::kColors;
  return sensor.type().starts_with("depth") ? Kind::kDepths : Kind::kBoth;
}

CameraSensor::CameraSensor(const SensorContext& context, CameraSurroundings& surroundings)
    : CameraOf(context, surroundings,
               kindOf(context.sensor) == Kind::kBoth ? CameraBody::InfoPlace::kBelow : CameraBody::InfoPlace::kBeside),
      kind_(kindOf(context.sensor)),
      settings_(body_.settings()),
      topic_(context.topic),
      noise_(context.noises.add(settings_.noise, "image")),
      depthNoise_(context.noises.add(settings_.noise, "depth")) {
  if (kind_ != Kind::kDepths && imageFormat(settings_.format) == nullptr) {
    throw body_.error("has an unsupported <format>", "use R8G8B8, B8G8R8, L8 or L16");
  }
  view_ = depthView_ = body_.view();
  if (settings_.depthClip) {
    depthView_.near = settings_.depthClip->near;
    depthView_.far = settings_.depthClip->far;
  }
  if (body_.wideLens()) {
    wideLens_.emplace(*body_.wideLens(), *settings_.lens, view_);
  } else if (settings_.distortion && kind_ == Kind::kColors) {
    distortion_.emplace(*settings_.distortion, view_);
  }

  if (kind_ == Kind::kBoth) depthImages_ = context.advertise(SensorReadings::kDepth);
  if (kind_ != Kind::kColors) points_ = context.advertise(SensorReadings::kPoints);
  beginMessages();
}

void CameraSensor::beginMessages() {
  const std::uint32_t width = settings_.width, height = settings_.height;
  if (kind_ == Kind::kDepths) {
    beginImage(width, height, ignition::msgs::R_FLOAT32, sizeof(float), message());
  } else {
    const ImageFormat& format = *imageFormat(settings_.format);
    beginImage(width, height, format.type, format.bytes, message());
  }
  if (kind_ == Kind::kColors) return;
  if (kind_ == Kind::kBoth) beginImage(width, height, ignition::msgs::R_FLOAT32, sizeof(float), depthImage_);
  beginCloud(kCameraPointFields, width, height, cloud_);
}

bool CameraSensor::isHeardElsewhere() const {
  return body_.isInfoHeard() || isDepthHeard() || arePointsHeard() || settings_.savesPictures;
}

/// @return Whether the rendered pixels need no processing, and at most one subscriber took the last image.
bool CameraSensor::isDrawnAsItIsSent() const {
  return settings_.format == PixelFormat::kR8G8B8 && !noise_.isOn() && !distortion_ && !wideLens_ &&
         !settings_.savesPictures && writes_ <= 1;
}

void CameraSensor::drawColors() {
  drawing_ = Drawing::kDone;
  colors_.resize(std::size_t{3} * settings_.width * settings_.height);
  if (distortion_) {
    PictureView source = distortion_->source();
    source.X_WorldEye = view_.X_WorldEye;
    drawn_.resize(std::size_t{3} * source.width * source.height);
    body_.scene().drawColors(source, drawn_);
    distortion_->apply(drawn_, colors_);
  } else if (wideLens_) {
    wideLens_->draw(body_.scene(), view_.X_WorldEye, colors_);
  } else {
    body_.scene().drawColors(view_, colors_);
  }
  if (!noise_.isOn()) return;
  for (std::uint8_t& value : colors_) {
    const double share = std::clamp(noise_.apply(value / 255.0), 0.0, 1.0);
    value = static_cast<std::uint8_t>(std::lround(share * 255));
  }
}

void CameraSensor::drawDepths() {
  depths_.resize(std::size_t{settings_.width} * settings_.height);
  body_.scene().drawDepths(depthView_, depths_);
  body_.scene().scatterDepths(depthView_, body_.sensor().scopedName(), depths_);
  if (!depthNoise_.isOn()) return;
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
  view_.X_WorldEye = depthView_.X_WorldEye = body_.pose();
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
    body_.scene().drawColors(view_, {to, place.size()});
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
  body_.publishInfo(message().header());
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
  body_.save([this](const std::filesystem::path& folder, std::uint64_t number) {
    const std::string name = std::string(body_.sensor().name()) + "_" + std::to_string(number) + ".png";
    CameraScene::writePicture(folder / name, settings_.width, settings_.height, colors_);
  });
}

}  // namespace pongsim
