#include "thermal_camera.hh"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace pongsim {

namespace {

// [K] per unit, as in Fortress
constexpr double kFineResolution = 0.01;
constexpr double kCoarseResolution = 3;

}  // namespace

ThermalCamera::ThermalCamera(const SensorContext& context, CameraSurroundings& surroundings)
    : CameraOf(context, surroundings, CameraBody::InfoPlace::kBeside),
      topic_(context.topic),
      noise_(context.noises.add(body_.settings().noise, "image")),
      hasEightBits_(body_.settings().format == PixelFormat::kL8),
      resolution_(body_.settings().thermal.resolution.value_or(hasEightBits_ ? kCoarseResolution : kFineResolution)) {
  // any format but L8 means 16 bits, as in Fortress
  beginImage(body_.settings().width, body_.settings().height,
             hasEightBits_ ? ignition::msgs::L_INT8 : ignition::msgs::L_INT16, hasEightBits_ ? 1 : 2, message());
}

void ThermalCamera::measure() {
  if (!topic_.hasSubscribers() && !body_.saves()) return;
  const ThermalSettings& thermal = body_.settings().thermal;
  temperatures_.resize(body_.pixelCount());
  body_.scene().drawTemperatures(body_.view(), temperatures_);
  const double most =
      hasEightBits_ ? std::numeric_limits<std::uint8_t>::max() : std::numeric_limits<std::uint16_t>::max();
  values_.resize(temperatures_.size());
  std::ranges::transform(temperatures_, values_.begin(), [&](float temperature) {
    double value = std::clamp(static_cast<double>(temperature), thermal.coldest, thermal.hottest) / resolution_;
    if (noise_.isOn()) value = noise_.apply(value / most) * most;
    return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0, most)));
  });
}

std::optional<Bulk> ThermalCamera::bulk() {
  return Bulk{.size = body_.pixelCount() * (hasEightBits_ ? 1 : 2),
              .write = [this](std::span<std::byte> to) { write(to); }};
}

void ThermalCamera::write(std::span<std::byte> to) const {
  // a new subscriber gets the previous image, or a black one
  if (values_.empty()) {
    std::ranges::fill(to, std::byte(0));
  } else if (hasEightBits_) {
    std::ranges::transform(values_, to.begin(), [](std::uint16_t value) { return static_cast<std::byte>(value); });
  } else {
    std::memcpy(to.data(), values_.data(), to.size());
  }
}

std::vector<std::uint8_t> ThermalCamera::shades() const {
  const auto [least, most] = std::ranges::minmax(values_);
  const int range = std::max(most - least, 1);
  std::vector<std::uint8_t> pixels;
  pixels.reserve(3 * values_.size());
  for (const std::uint16_t value : values_)
    pixels.insert(pixels.end(), 3, static_cast<std::uint8_t>(255 * (value - least) / range));
  return pixels;
}

void ThermalCamera::publishElsewhere() {
  body_.publishInfo(message().header());
  body_.save([this](const std::filesystem::path& folder, std::uint64_t number) {
    const std::string name = std::string(body_.sensor().name()) + "_" + std::to_string(number) + ".png";
    CameraScene::writePicture(folder / name, body_.settings().width, body_.settings().height, shades());
  });
}

}  // namespace pongsim
