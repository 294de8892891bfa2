#include "wide_lens.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "pongsim/math.hh"

namespace pongsim {

namespace {

using std::numbers::pi;
using Function = LensSettings::Function;
using Type = LensSettings::Type;

/// The lens fades to black within this radius before the cut-off angle, as in Gazebo.
constexpr double kFading = 0.02;
// so that colours can be interpolated up to the edges of a picture
constexpr std::uint32_t kMargin = 1;

LensSettings::Custom termsOf(const LensSettings& settings) {
  switch (settings.type) {
    case Type::kGnomonical:
      return {1, 1, 0, 1, Function::kTan};
    case Type::kStereographic:
      return {2, 2, 0, 1, Function::kTan};
    case Type::kEquidistant:
      return {1, 1, 0, 1, Function::kId};
    case Type::kEquisolidAngle:
      return {2, 2, 0, 1, Function::kSin};
    case Type::kOrthographic:
      return {1, 1, 0, 1, Function::kSin};
    default:
      return settings.custom;
  }
}

double applied(Function function, double angle) {
  return function == Function::kSin ? math::sin(angle) : function == Function::kTan ? math::tan(angle) : angle;
}

/// @return The six directions in which pictures are taken, each with the axes of a camera: ahead, left, up.
const std::array<Matrix3, 6>& faceAxes() {
  static const std::array<Matrix3, 6> axes = [] {
    std::array<Matrix3, 6> made;
    const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
    const std::array<std::array<Vector3, 2>, 6> aheadAndUp{{{x, z}, {-x, z}, {y, z}, {-y, z}, {z, -x}, {-z, x}}};
    for (std::size_t i = 0; i < made.size(); ++i) {
      const auto& [ahead, up] = aheadAndUp[i];
      made[i] << ahead, up.cross(ahead), up;
    }
    return made;
  }();
  return axes;
}

/// @return 0 up to an edge, 1 from another one on, and smooth in between.
double smoothStep(double from, double to, double value) {
  const double share = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

}  // namespace

Outcome<LensFunction> LensFunction::of(const LensSettings& settings, double horizontalFov) {
  LensFunction lens;
  lens.terms_ = termsOf(settings);
  if (lens.terms_.c2 == 0) return {std::nullopt, "has a lens that shows nothing: its <c2> is zero"};
  if (settings.scalesToHorizontalFov) lens.terms_.f = 1;
  const double edge = lens.radius(horizontalFov / 2);
  if (settings.scalesToHorizontalFov) {
    // the field of view fills the width
    if (!(edge > 0) || !std::isfinite(edge)) {
      return {std::nullopt, "has a lens that can't show a field of view of " + std::to_string(horizontalFov) + " rad"};
    }
    lens.terms_.f = 1 / edge;
  }
  if (!(lens.terms_.c1 * lens.terms_.f > 0)) {
    return {std::nullopt, "has a lens that shows nothing: its <c1> times <f> is not above zero"};
  }
  return {lens, {}};
}

double LensFunction::radius(double angle) const {
  return terms_.c1 * terms_.f * applied(terms_.function, angle / terms_.c2 + terms_.c3);
}

std::optional<double> LensFunction::angle(double radius) const {
  const double value = radius / (terms_.c1 * terms_.f);
  double inner = value;
  if (terms_.function == Function::kSin) {
    if (std::abs(value) > 1) return std::nullopt;
    inner = math::asin(value);
  } else if (terms_.function == Function::kTan) {
    inner = math::atan(value);
  }
  return (inner - terms_.c3) * terms_.c2;
}

double LensFunction::largestRadius(double angle) const {
  const double inner = angle / terms_.c2 + terms_.c3;
  if (terms_.function == Function::kTan && inner >= pi / 2) return std::numeric_limits<double>::infinity();
  if (terms_.function == Function::kSin && inner >= pi / 2) return terms_.c1 * terms_.f;
  return radius(angle);
}

double LensFunction::slope() const {
  const double inner = terms_.c3, scale = terms_.c1 * terms_.f / terms_.c2;
  if (terms_.function == Function::kSin) return scale * math::cos(inner);
  if (terms_.function == Function::kTan) return scale / (math::cos(inner) * math::cos(inner));
  return scale;
}

WideLens::WideLens(const LensFunction& function, const LensSettings& settings, const PictureView& view)
    : faceView_(view) {
  const auto edge = static_cast<std::uint32_t>(settings.environmentTextureSize);
  faceView_.width = faceView_.height = edge + 2 * kMargin;
  faceView_.fx = faceView_.fy = edge / 2.0;
  faceView_.cx = faceView_.cy = faceView_.width / 2.0;
  faceView_.skew = 0;
  const double half = view.width / 2.0, cutRadius = function.largestRadius(settings.cutoffAngle);
  samples_.reserve(std::size_t{view.width} * view.height);
  for (std::uint32_t row = 0; row < view.height; ++row) {
    for (std::uint32_t column = 0; column < view.width; ++column) {
      const double right = (column + 0.5) / half - 1, down = (row + 0.5 - view.height / 2.0) / half;
      const double radius = math::hypot(right, down);
      const std::optional<double> angle = function.angle(radius);
      const double brightness = std::isfinite(cutRadius) ? 1 - smoothStep(cutRadius - kFading, cutRadius, radius) : 1;
      Sample sample;
      if (angle && *angle <= pi && brightness > 0) {
        const double aside = radius > 0 ? math::sin(*angle) / radius : 0;
        sample = sampleAt({math::cos(*angle), -aside * right, -aside * down});
        sample.brightness = static_cast<float>(brightness);
      }
      samples_.push_back(sample);
    }
  }
  for (const Sample& sample : samples_) {
    if (sample.face < 0) continue;
    std::vector<std::uint8_t>& face = faces_[static_cast<std::size_t>(sample.face)];
    if (face.empty()) face.resize(std::size_t{3} * faceView_.width * faceView_.height);
  }
}

WideLens::Sample WideLens::sampleAt(const Vector3& direction) const {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  const int face = 2 * axis + (direction[axis] < 0 ? 1 : 0);
  const Vector3 there = faceAxes()[static_cast<std::size_t>(face)].transpose() * direction;
  return {face, static_cast<float>(faceView_.cx - faceView_.fx * there.y() / there.x()),
          static_cast<float>(faceView_.cy - faceView_.fy * there.z() / there.x()), 1};
}

void WideLens::draw(CameraScene& scene, const Pose& X_WorldEye, std::span<std::uint8_t> pixels) {
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    if (faces_[face].empty()) continue;
    faceView_.X_WorldEye = X_WorldEye * Pose{Vector3::Zero(), Quaternion(faceAxes()[face])};
    scene.drawColors(faceView_, faces_[face]);
  }
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sample& sample = samples_[i];
    if (sample.face < 0) {
      std::ranges::fill(pixels.subspan(3 * i, 3), std::uint8_t{0});
      continue;
    }
    const std::vector<std::uint8_t>& face = faces_[static_cast<std::size_t>(sample.face)];
    // interpolates between the centres of four pixels
    const float x = sample.column - 0.5F, y = sample.row - 0.5F;
    const auto column = std::min(static_cast<std::size_t>(x), std::size_t{faceView_.width} - 2);
    const auto row = std::min(static_cast<std::size_t>(y), std::size_t{faceView_.height} - 2);
    const float right = x - static_cast<float>(column), below = y - static_cast<float>(row);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const auto at = [&](std::size_t u, std::size_t v) {
        return static_cast<float>(face[3 * (v * faceView_.width + u) + channel]);
      };
      const float above = (1 - right) * at(column, row) + right * at(column + 1, row);
      const float under = (1 - right) * at(column, row + 1) + right * at(column + 1, row + 1);
      pixels[3 * i + channel] =
          static_cast<std::uint8_t>(std::lround(sample.brightness * ((1 - below) * above + below * under)));
    }
  }
}

}  // namespace pongsim
