#include "cli/view/viewpoint.hh"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <vector>

namespace pongsim::cli {

namespace {

// relative to the visible area, on each side
constexpr double kFrameMargin = 1.06;

/// @return The orientation that looks along a direction with a level horizon.
Quaternion lookingAlong(const Vector3& direction) {
  const double yaw = std::atan2(direction.y(), direction.x());
  const double pitch = -std::atan2(direction.z(), direction.head<2>().norm());
  return fromRollPitchYaw(0, pitch, yaw);
}

}  // namespace

std::optional<Pose> readViewpoint(const std::string& text) {
  std::istringstream words(text);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (*end != '\0' || !std::isfinite(numbers.back())) return std::nullopt;
  }
  if (numbers.size() != 3 && numbers.size() != 6) return std::nullopt;
  const Vector3 position(numbers[0], numbers[1], numbers[2]);
  if (numbers.size() == 3) return Pose{position, lookingAlong(-position)};
  return Pose{position, fromRollPitchYaw(numbers[3], numbers[4], numbers[5])};
}

void lookAt(const Eigen::AlignedBox3d& box, PictureView& view) {
  const Vector3 ahead = Vector3(0.72, 0.5, -0.48).normalized();
  view.X_WorldEye.rotation = lookingAlong(ahead);
  const Vector3 left = view.X_WorldEye.rotation * Vector3::UnitY(), up = view.X_WorldEye.rotation * Vector3::UnitZ();
  double distance = 0.2;
  for (int i = 0; i < 8; ++i) {
    const Vector3 corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)) - box.center();
    const double across = std::abs(left.dot(corner)) * 2 * view.fx / view.width;
    const double along = std::abs(up.dot(corner)) * 2 * view.fy / view.height;
    distance = std::max(distance, kFrameMargin * std::max(across, along) - ahead.dot(corner));
  }
  view.X_WorldEye.position = box.center() - distance * ahead;
}

}  // namespace pongsim::cli
