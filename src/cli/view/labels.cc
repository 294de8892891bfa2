#include "cli/view/labels.hh"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "rendering/small_font.hh"

namespace pongsim::cli {

namespace {

using rendering::kLetterAdvance;
using rendering::kLetterHeight;
using rendering::kLetterWidth;
using rendering::SmallLetter;

/// Image rows for each dot of a character.
constexpr double kRowsPerDot = 300;
/// How much of the image shines through the panel behind a name.
constexpr int kPanelShare = 3, kPanelWhole = 8;

/// Area of a label in pixels; the ends are exclusive.
struct Panel {
  std::string letters;
  long left = 0, right = 0, top = 0, bottom = 0;

  bool meets(const Panel& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// Lays out and draws the labels' panels.
class LabelWriter {
 public:
  LabelWriter(std::uint32_t width, std::uint32_t height, std::span<std::uint8_t> pixels)
      : width_(width), height_(height), dot_(std::max(1L, std::lround(height / kRowsPerDot))), pixels_(pixels) {}

  void add(const Label& label) {
    Panel panel;
    panel.letters = rendering::lettersOf(label.text);
    const long across = (static_cast<long>(panel.letters.size() * kLetterAdvance) + 1) * dot_;
    const long down = (static_cast<long>(kLetterHeight) + 2) * dot_;
    panel.left = std::lround(label.column) - across / 2;
    panel.right = panel.left + across;
    panel.bottom = std::lround(label.row) - dot_;
    panel.top = panel.bottom - down;
    while (true) {
      const auto covered = std::ranges::find_if(panels_, [&](const Panel& other) { return panel.meets(other); });
      if (covered == panels_.end()) break;
      panel.bottom = covered->top;
      panel.top = panel.bottom - down;
    }
    draw(panel);
    panels_.push_back(std::move(panel));
  }

 private:
  void draw(const Panel& panel) {
    fill(panel.left, panel.top, panel.right, panel.bottom,
         [](std::uint8_t value) { return static_cast<std::uint8_t>(value * kPanelShare / kPanelWhole); });
    long left = panel.left + dot_;
    for (const char letter : panel.letters) {
      const SmallLetter dots = rendering::smallLetter(static_cast<unsigned char>(letter));
      for (std::size_t column = 0; column < kLetterWidth; ++column) {
        for (std::size_t row = 0; row < kLetterHeight; ++row) {
          if ((dots[column] >> row & 1U) == 0) continue;
          const long x = left + static_cast<long>(column) * dot_, y = panel.top + (static_cast<long>(row) + 1) * dot_;
          fill(x, y, x + dot_, y + dot_, [](std::uint8_t) { return std::uint8_t{255}; });
        }
      }
      left += static_cast<long>(kLetterAdvance) * dot_;
    }
  }

  template <class Change>
  void fill(long left, long top, long right, long bottom, Change change) {
    for (long row = std::max(0L, top); row < std::min(height_, bottom); ++row) {
      for (long column = std::max(0L, left); column < std::min(width_, right); ++column) {
        for (long i = 0; i < 3; ++i) {
          std::uint8_t& value = pixels_[static_cast<std::size_t>(3 * (row * width_ + column) + i)];
          value = change(value);
        }
      }
    }
  }

  const long width_;
  const long height_;
  /// Size of a character's dot [pixels].
  const long dot_;
  const std::span<std::uint8_t> pixels_;
  std::vector<Panel> panels_;
};

/// @return Pixel coordinates of a point in the world; nothing if it is outside the image.
std::optional<Eigen::Vector2d> pixelOf(const Vector3& p_World, const PictureView& view) {
  const Vector3 place = view.X_WorldEye.inverse() * p_World;
  if (place.x() <= view.near) return std::nullopt;
  const Eigen::Vector2d pixel(view.cx - (view.fx * place.y() + view.skew * place.z()) / place.x(),
                              view.cy - view.fy * place.z() / place.x());
  const bool isInside = pixel.x() >= 0 && pixel.x() < view.width && pixel.y() >= 0 && pixel.y() < view.height;
  return isInside ? std::optional(pixel) : std::nullopt;
}

}  // namespace

std::vector<Label> labelsOf(Sight& sight, const PictureView& view) {
  std::vector<Label> labels;
  for (const std::string& name : sight.names()) {
    if (name.find("::") != std::string::npos) continue;
    const Eigen::AlignedBox3d box = sight.bounds(name);
    if (box.isEmpty()) continue;
    std::optional<Eigen::Vector2d> highest;
    for (int i = 0; i < 8; ++i) {
      const auto pixel = pixelOf(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)), view);
      if (pixel && (!highest || pixel->y() < highest->y())) highest = pixel;
    }
    if (!highest) highest = pixelOf(box.center(), view);
    if (highest) labels.push_back({name, highest->x(), highest->y()});
  }
  return labels;
}

void drawLabels(std::vector<Label> labels, std::uint32_t width, std::uint32_t height, std::span<std::uint8_t> pixels) {
  // from the lowest up: higher ones make room
  std::ranges::stable_sort(labels, std::greater<>(), &Label::row);
  LabelWriter writer(width, height, pixels);
  for (const Label& label : labels) writer.add(label);
}

}  // namespace pongsim::cli
