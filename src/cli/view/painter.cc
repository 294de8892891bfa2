#include "cli/view/painter.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cli/options/number_option.hh"
#include "pongsim/sensing/label_colors.hh"

namespace pongsim::cli {

namespace {

void paintGrey(float brightness, std::size_t pixel, std::span<std::uint8_t> pixels) {
  const auto grey = static_cast<std::uint8_t>(std::lround(255 * std::clamp(brightness, 0.0F, 1.0F)));
  std::ranges::fill(pixels.subspan(3 * pixel, 3), grey);
}

/// @return With two decimals at most.
std::string roundedText(float value) { return shortNumber(std::round(100.0 * value) / 100); }

}  // namespace

void Painter::draw(Sight& sight, const PictureView& view, std::span<std::uint8_t> pixels) {
  switch (kind_) {
    case PictureKind::kColors:
      return sight.drawColors(view, pixels);
    case PictureKind::kDepths:
      return drawDepths(sight, view, pixels);
    case PictureKind::kTemperatures:
      return drawTemperatures(sight, view, pixels);
    case PictureKind::kLabels:
      return drawLabels(sight, view, pixels);
  }
}

/// The brightness is proportional to the inverse of the distance, which is linear in an image.
void Painter::drawDepths(Sight& sight, const PictureView& view, std::span<std::uint8_t> pixels) {
  values_.resize(pixels.size() / 3);
  sight.drawDepths(view, values_);
  if (!nearest_) nearest_ = std::ranges::min(values_);
  for (std::size_t i = 0; i < values_.size(); ++i) {
    paintGrey(std::isinf(values_[i]) ? 0 : *nearest_ / values_[i], i, pixels);
  }
}

void Painter::drawTemperatures(Sight& sight, const PictureView& view, std::span<std::uint8_t> pixels) {
  values_.resize(pixels.size() / 3);
  sight.drawTemperatures(view, values_);
  if (!temperatures_) {
    const auto [coldest, hottest] = std::ranges::minmax(values_);
    temperatures_ = {coldest, hottest};
  }
  const auto& [coldest, hottest] = *temperatures_;
  const float range = hottest > coldest ? hottest - coldest : 1;
  for (std::size_t i = 0; i < values_.size(); ++i) paintGrey((values_[i] - coldest) / range, i, pixels);
}

void Painter::drawLabels(Sight& sight, const PictureView& view, std::span<std::uint8_t> pixels) {
  numbers_.resize(pixels.size() / 3);
  sight.drawNumbers(view, numbers_);
  const std::vector<LabelLook> looks = labelLooks(sight.visuals(), CameraSettings::Segmentation::kSemantic);
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const LabelColor color = numbers_[i] == 0 ? LabelColor() : looks[numbers_[i] - 1].color;
    std::ranges::copy(color, pixels.subspan(3 * i, 3).begin());
  }
}

std::string Painter::legend() const {
  if (nearest_) {
    return std::isinf(*nearest_) ? "nothing is in the picture"
                                 : "white is " + roundedText(*nearest_) + " m away, half as bright twice as far";
  }
  if (!temperatures_) return {};
  return "black is " + roundedText(temperatures_->coldest) + " K, white " + roundedText(temperatures_->hottest) + " K";
}

}  // namespace pongsim::cli
