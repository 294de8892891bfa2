#include "sdf/text/degrees.hh"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/parse_number.hh"
#include "pongsim/types.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

constexpr double kDegreesInRadian = 180 / std::numbers::pi;

/// @param numbers A pose: first the position, then the rotation.
/// @return Roll, pitch, yaw [degrees]; nothing if the numbers are not a rotation.
std::optional<Vector3> anglesOf(const Element& pose, const std::vector<double>& numbers) {
  if (pose.attributeOr("rotation_format", "euler_rpy") == "quat_xyzw") {
    if (numbers.size() != 7) return std::nullopt;
    const Quaternion rotation(numbers[6], numbers[3], numbers[4], numbers[5]);
    return Vector3(rollPitchYawOf(rotation.normalized()) * kDegreesInRadian);
  }
  if (numbers.size() != 6) return std::nullopt;
  const bool areDegrees = parseFlag(pose.attributeOr("degrees", "false")).value_or(false);
  const double unit = areDegrees ? 1 / kDegreesInRadian : 1;
  return Vector3(rollPitchYawOf(fromRollPitchYaw(numbers[3] * unit, numbers[4] * unit, numbers[5] * unit)) *
                 kDegreesInRadian);
}

double snapped(double angle, const DegreeOptions& options) {
  // anything smaller is rounding error
  if (std::abs(angle) < 1e-6) return 0;
  if (options.snapTo == 0) return angle;
  const double multiple = std::round(angle / options.snapTo) * options.snapTo;
  return std::abs(angle - multiple) < options.tolerance ? multiple : angle;
}

/// @return The number with six digits; zero without a minus sign.
std::string digits(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value == 0 ? 0 : value);
  return text.data();
}

void turn(Element& pose, const DegreeOptions& options) {
  const std::optional<std::vector<double>> numbers =
      pose.text.empty() ? std::vector<double>(6, 0) : base::parseDoubles(pose.text);
  const std::optional<Vector3> angles = numbers ? anglesOf(pose, *numbers) : std::nullopt;
  if (!angles) return;
  pose.text = digits((*numbers)[0]) + " " + digits((*numbers)[1]) + " " + digits((*numbers)[2]) + "  ";
  for (const double angle : *angles) pose.text += " " + digits(snapped(angle, options));
  std::erase_if(pose.attributes, [](const Element::Attribute& each) {
    return each.name == "degrees" || each.name == "rotation_format";
  });
  pose.attributes.insert(pose.attributes.begin(),
                         {{"degrees", "true", pose.position}, {"rotation_format", "euler_rpy", pose.position}});
}

}  // namespace

void turnToDegrees(Element& root, const DegreeOptions& options) {
  for (Element& child : root.children) {
    if (child.name == "pose") turn(child, options);
    if (child.name != "plugin") turnToDegrees(child, options);
  }
}

}  // namespace pongsim::sdf
