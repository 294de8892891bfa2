#include "web/pictures/picture_wish.hh"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "pongsim/math.hh"

namespace pongsim::web {

namespace {

using nlohmann::json;

// [m]
constexpr double kFarthest = 1e6;
// of the field of view [rad]
constexpr double kNarrowest = 0.01;
constexpr double kWidest = 3;
constexpr double kNear = 0.01;

std::optional<Pose> poseIn(const json& wish) {
  const auto found = wish.find("pose");
  std::array<double, 7> numbers{};
  if (found == wish.end() || !found->is_array() || found->size() != numbers.size()) return std::nullopt;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const json& number = (*found)[i];
    if (!number.is_number()) return std::nullopt;
    numbers[i] = number.get<double>();
    if (!(std::abs(numbers[i]) <= kFarthest)) return std::nullopt;
  }
  const Eigen::Quaterniond rotation(numbers[6], numbers[3], numbers[4], numbers[5]);
  if (rotation.norm() < 0.5) return std::nullopt;
  Pose pose;
  pose.position = {numbers[0], numbers[1], numbers[2]};
  pose.rotation = rotation.normalized();
  return pose;
}

std::optional<std::uint32_t> edgeIn(const json& wish, const char* name) {
  const auto found = wish.find(name);
  if (found == wish.end() || !found->is_number_integer()) return std::nullopt;
  const auto edge = found->get<std::int64_t>();
  if (edge < kShortestEdge || edge > kLongestEdge) return std::nullopt;
  return static_cast<std::uint32_t>(edge);
}

}  // namespace

Outcome<PictureView> readPictureWish(const json& wish) {
  if (!wish.is_object()) return {{}, "a picture is asked for by a JSON object"};
  const auto pose = poseIn(wish);
  if (!pose) return {{}, "a picture's 'pose' must have seven numbers up to 1e6, the last four a rotation"};
  const auto width = edgeIn(wish, "width"), height = edgeIn(wish, "height");
  if (!width || !height) {
    return {{},
            "a picture's 'width' and 'height' must be from " + std::to_string(kShortestEdge) + " to " +
                std::to_string(kLongestEdge)};
  }
  const auto angle = wish.find("fieldOfView");
  if (angle == wish.end() || !angle->is_number() || !(angle->get<double>() >= kNarrowest) ||
      !(angle->get<double>() <= kWidest)) {
    return {{}, "a picture's 'fieldOfView' must be from 0.01 to 3"};
  }
  PictureView view;
  view.X_WorldEye = *pose;
  view.width = *width;
  view.height = *height;
  view.fx = view.fy = *height / (2 * math::tan(angle->get<double>() / 2));
  view.cx = *width / 2.0;
  view.cy = *height / 2.0;
  view.near = kNear;
  view.far = std::numeric_limits<double>::infinity();
  const auto grid = wish.find("grid");
  view.showsGrid = grid != wish.end() && grid->is_boolean() && grid->get<bool>();
  return {view, {}};
}

}  // namespace pongsim::web
