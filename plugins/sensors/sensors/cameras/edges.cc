#include "edges.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace pongsim {

namespace {

using Eigen::Vector2d;
using Ends = std::pair<Vector2d, Vector2d>;

/// Liang and Barsky, "A new concept and method for line clipping" (1984).
/// @return The part of an edge within a box, if any.
std::optional<Ends> clipped(const Vector2d& from, const Vector2d& to, const Eigen::AlignedBox2d& box) {
  double first = 0, last = 1;
  const Vector2d way = to - from;
  for (int axis = 0; axis < 2; ++axis) {
    if (way[axis] == 0) {
      if (from[axis] < box.min()[axis] || from[axis] > box.max()[axis]) return std::nullopt;
      continue;
    }
    const double a = (box.min()[axis] - from[axis]) / way[axis], b = (box.max()[axis] - from[axis]) / way[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first <= last)) return std::nullopt;
  return Ends(from + first * way, from + last * way);
}

}  // namespace

void addEdges(const Eigen::AlignedBox2d& box, std::vector<Vector2d>& edges) {
  const Vector2d least = box.min(), most = box.max();
  const std::array<Vector2d, 4> corners{least, Vector2d(most.x(), least.y()), most, Vector2d(least.x(), most.y())};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    edges.push_back(corners[i]);
    edges.push_back(corners[(i + 1) % corners.size()]);
  }
}

void addEdges(const TurnedBox& box, const PictureView& view, std::vector<Vector2d>& edges) {
  std::array<Vector2d, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3 sides((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5, (i & 4) != 0 ? 0.5 : -0.5);
    const Vector3 corner = box.pose * Vector3(box.size.cwiseProduct(sides));
    if (corner.z() >= 0) return;
    const double ahead = -corner.z();
    corners[i] = {view.cx + (view.fx * corner.x() - view.skew * corner.y()) / ahead,
                  view.cy - view.fy * corner.y() / ahead};
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const std::size_t axis : {1U, 2U, 4U}) {
      if ((i & axis) != 0) continue;
      edges.push_back(corners[i]);
      edges.push_back(corners[i | axis]);
    }
  }
}

void drawEdges(std::span<const Vector2d> edges, std::uint32_t width, std::uint32_t height,
               std::span<std::uint8_t> pixels) {
  constexpr std::array<std::uint8_t, 3> kGreen{0, 255, 0};
  // a box ends at the last pixel
  const Eigen::AlignedBox2d image(Vector2d(0, 0), Vector2d(width, height));
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
    const std::optional<Ends> ends = clipped(edges[i], edges[i + 1], image);
    if (!ends) continue;
    const Vector2d way = ends->second - ends->first;
    const int steps = static_cast<int>(std::ceil(way.cwiseAbs().maxCoeff()));
    for (int step = 0; step <= steps; ++step) {
      const Vector2d place = ends->first + way * (steps > 0 ? static_cast<double>(step) / steps : 0);
      const auto column = std::min(static_cast<std::uint32_t>(place.x()), width - 1);
      const auto row = std::min(static_cast<std::uint32_t>(place.y()), height - 1);
      std::ranges::copy(kGreen, pixels.begin() + 3 * (std::ptrdiff_t{row} * width + column));
    }
  }
}

}  // namespace pongsim
