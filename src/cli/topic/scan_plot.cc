#include "cli/topic/scan_plot.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <vector>

namespace pongsim::cli {

namespace {

/// Dots in a rectangle of Braille characters.
class Canvas {
 public:
  Canvas(int columns, int rows)
      : columns_(columns), rows_(rows), letters_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  /// Number of dots from the centre to the nearest edge.
  double radius() const { return std::min(2 * columns_, 4 * rows_) / 2.0 - 1; }

  /// @param right, up From the centre, in dots. Points outside the canvas are ignored.
  void draw(double right, double up) {
    if (!(std::abs(right) < kMost && std::abs(up) < kMost)) return;
    const auto x = static_cast<int>(std::lround(columns_ - 0.5 + right));
    const auto y = static_cast<int>(std::lround(2 * rows_ - 0.5 - up));
    if (x < 0 || y < 0 || x >= 2 * columns_ || y >= 4 * rows_) return;
    // the bits of Unicode's Braille characters: 1 to 3 down the left side, 4 to 6 down the right, 7 and 8 below
    constexpr std::array<std::array<std::uint8_t, 2>, 4> kBits{
        {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}}};
    letterAt(x / 2, y / 4) |= kBits[static_cast<std::size_t>(y % 4)][static_cast<std::size_t>(x % 2)];
  }

  std::string text() const {
    std::string text;
    for (int row = 0; row < rows_; ++row) {
      std::string line;
      for (int column = 0; column < columns_; ++column) {
        const bool isMiddle = column == columns_ / 2 && row == rows_ / 2;
        line += isMiddle ? "+" : letter(letters_[index(column, row)]);
      }
      text += line.erase(line.find_last_not_of(' ') + 1) + '\n';
    }
    return text;
  }

 private:
  // far beyond any canvas
  static constexpr double kMost = 1e6;

  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * columns_ + column); }
  std::uint8_t& letterAt(int column, int row) { return letters_[index(column, row)]; }

  /// @return In UTF-8.
  static std::string letter(std::uint8_t dots) {
    if (dots == 0) return " ";
    return {'\xe2', static_cast<char>(0xa0 | dots >> 6), static_cast<char>(0x80 | (dots & 0x3f))};
  }

  int columns_;
  int rows_;
  std::vector<std::uint8_t> letters_;
};

/// @return The next larger round number, so that it seldom changes from scan to scan.
double roundedUp(double range) {
  const double power = std::pow(10, std::floor(std::log10(range)));
  for (const double factor : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0}) {
    if (factor * power >= range) return factor * power;
  }
  return 10 * power;
}

}  // namespace

std::string scanPlot(const msgs::ScanRow& scan, int columns, int rows) {
  double nearest = INFINITY, farthest = 0;
  std::size_t seen = 0, tooNear = 0;
  for (const double range : scan.ranges) {
    if (range == -INFINITY) ++tooNear;
    if (!std::isfinite(range)) continue;
    ++seen;
    nearest = std::min(nearest, range);
    farthest = std::max(farthest, range);
  }
  const double ring = farthest > 0 ? roundedUp(farthest) : 1;

  Canvas canvas(columns, rows);
  constexpr int kRingDots = 72;
  for (int i = 0; i < kRingDots; ++i) {
    const double angle = i * 2 * std::numbers::pi / kRingDots;
    canvas.draw(canvas.radius() * std::cos(angle), canvas.radius() * std::sin(angle));
  }
  const double scale = canvas.radius() / ring * std::cos(scan.elevation);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i], angle = scan.firstAngle + static_cast<double>(i) * scan.angleStep;
    if (std::isfinite(range) && std::isfinite(angle)) {
      canvas.draw(-range * scale * std::sin(angle), range * scale * std::cos(angle));
    }
  }

  char numbers[200];
  std::snprintf(numbers, sizeof(numbers), "t %.3f s  ring %g m  %zu of %zu beams hit", toSeconds(scan.time), ring, seen,
                scan.ranges.size());
  std::string text = canvas.text() + numbers;
  if (seen > 0) {
    std::snprintf(numbers, sizeof(numbers), ", nearest %.3f m", nearest);
    text += numbers;
  }
  if (tooNear > 0) text += ", " + std::to_string(tooNear) + " too near";
  return text + '\n';
}

}  // namespace pongsim::cli
