#include "camera_lens.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "pongsim/math.hh"

namespace pongsim {

namespace {

using Eigen::Vector2d;

// largest margin on each side that is rendered for a distorted image, in image sizes
constexpr double kMostMargin = 0.5;

Vector2d distorted(const DistortionSettings& k, const Vector2d& point) {
  const double x = point.x(), y = point.y(), r2 = point.squaredNorm();
  const double radial = 1 + r2 * (k.k1 + r2 * (k.k2 + r2 * k.k3));
  return {x * radial + 2 * k.p1 * x * y + k.p2 * (r2 + 2 * x * x),
          y * radial + 2 * k.p2 * x * y + k.p1 * (r2 + 2 * y * y)};
}

/// @return The undistorted point shown there, found by iteration; nothing if the model has none.
std::optional<Vector2d> undistorted(const DistortionSettings& k, const Vector2d& shown) {
  constexpr int kMostSteps = 50;
  constexpr double kCloseEnough = 1e-7;
  Vector2d point = shown;
  for (int i = 0; i < kMostSteps; ++i) {
    const Vector2d error = distorted(k, point) - shown;
    if (!error.allFinite()) return std::nullopt;
    if (error.squaredNorm() < kCloseEnough * kCloseEnough) return point;
    point -= error;
  }
  return std::nullopt;
}

}  // namespace

PictureView viewOf(const CameraSettings& settings) {
  PictureView view;
  view.width = settings.width;
  view.height = settings.height;
  view.near = settings.clip.near;
  view.far = settings.clip.far;
  view.visibilityMask = settings.visibilityMask;
  view.antiAliasing = settings.antiAliasing;
  if (settings.lens && settings.lens->intrinsics) {
    const LensSettings::Intrinsics& lens = *settings.lens->intrinsics;
    view.fx = lens.fx;
    view.fy = lens.fy;
    view.cx = lens.cx;
    view.cy = lens.cy;
    view.skew = lens.skew;
  } else {
    view.fx = view.fy = view.width / (2 * math::tan(settings.horizontalFov / 2));
    view.cx = view.width / 2.0;
    view.cy = view.height / 2.0;
  }
  return view;
}

void fillIn(const CameraSettings& settings, const PictureView& view, ignition::msgs::CameraInfo& info) {
  info.set_width(settings.width);
  info.set_height(settings.height);
  const DistortionSettings k = settings.distortion.value_or(DistortionSettings());
  info.mutable_distortion()->set_model(ignition::msgs::CameraInfo::Distortion::PLUMB_BOB);
  for (const double value : {k.k1, k.k2, k.p1, k.p2, k.k3}) info.mutable_distortion()->add_k(value);
  for (const double value : {view.fx, view.skew, view.cx, 0.0, view.fy, view.cy, 0.0, 0.0, 1.0}) {
    info.mutable_intrinsics()->add_k(value);
  }
  LensSettings::Projection p{view.fx, view.fy, view.cx, view.cy, 0, 0};
  if (settings.lens && settings.lens->projection) p = *settings.lens->projection;
  for (const double value : {p.fx, 0.0, p.cx, p.tx, 0.0, p.fy, p.cy, p.ty, 0.0, 0.0, 1.0, 0.0}) {
    info.mutable_projection()->add_p(value);
  }
  for (int i = 0; i < 9; ++i) info.add_rectification_matrix(i % 4 == 0 ? 1 : 0);
}

Distortion::Distortion(const DistortionSettings& settings, const PictureView& view) : source_(view) {
  const Vector2d middle(settings.center.x() * view.width, settings.center.y() * view.height);
  const Vector2d focal(view.fx, view.fy);
  const Vector2d size(view.width, view.height);
  Eigen::AlignedBox2d needed(Vector2d::Zero(), size);
  const Eigen::AlignedBox2d most(-kMostMargin * size, (1 + kMostMargin) * size);
  std::vector<Vector2d> places;
  places.reserve(std::size_t{view.width} * view.height);
  for (std::uint32_t row = 0; row < view.height; ++row) {
    for (std::uint32_t column = 0; column < view.width; ++column) {
      const Vector2d shown = (Vector2d(column + 0.5, row + 0.5) - middle).cwiseQuotient(focal);
      const std::optional<Vector2d> found = undistorted(settings, shown);
      Vector2d place = Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
      if (found) {
        const Vector2d there = middle + found->cwiseProduct(focal);
        if (most.contains(there)) place = there;
      }
      if (place.allFinite()) needed.extend(place);
      places.push_back(place);
    }
  }
  const Vector2d start = needed.min().array().floor(), end = needed.max().array().ceil();
  source_.width = static_cast<std::uint32_t>(end.x() - start.x());
  source_.height = static_cast<std::uint32_t>(end.y() - start.y());
  source_.cx -= start.x();
  source_.cy -= start.y();
  places_.reserve(places.size());
  for (const Vector2d& place : places) places_.emplace_back((place - start).cast<float>());
}

void Distortion::apply(std::span<const std::uint8_t> drawn, std::span<std::uint8_t> pixels) const {
  const auto pixelAt = [&](int column, int row, std::size_t channel) {
    const int x = std::clamp(column, 0, static_cast<int>(source_.width) - 1);
    const int y = std::clamp(row, 0, static_cast<int>(source_.height) - 1);
    return static_cast<float>(
        drawn[3 * (static_cast<std::size_t>(y) * source_.width + static_cast<std::size_t>(x)) + channel]);
  };
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (!places_[i].allFinite()) {
      std::ranges::fill(pixels.subspan(3 * i, 3), std::uint8_t{0});
      continue;
    }
    // interpolates between the centres of four pixels
    const float x = places_[i].x() - 0.5F, y = places_[i].y() - 0.5F;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const float right = x - static_cast<float>(column), below = y - static_cast<float>(row);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const float above = (1 - right) * pixelAt(column, row, channel) + right * pixelAt(column + 1, row, channel);
      const float under =
          (1 - right) * pixelAt(column, row + 1, channel) + right * pixelAt(column + 1, row + 1, channel);
      pixels[3 * i + channel] = static_cast<std::uint8_t>(std::lround((1 - below) * above + below * under));
    }
  }
}

}  // namespace pongsim
