#include "sdf/values.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/parse_number.hh"
#include "sdf/value_check.hh"

namespace pongsim::sdf {

namespace {

constexpr double kUnlimited = 1e16;

/// Adds "<mass> is 'x', which is not a number".
void complain(const Element& element, std::string_view expected, Context& context, std::string hint = {}) {
  context.diagnostics.error(element.position,
                            "<" + element.name + "> is '" + quoted(element.text) + "', which is not " + std::string(expected),
                            std::move(hint));
}

/// @return The child, or null where there is nothing to read in it.
const Element* filledChild(const Element& parent, std::string_view child) {
  const Element* element = parent.child(child);
  return element != nullptr && !element->text.empty() ? element : nullptr;
}

/// Reads a number for which `isGood` holds.
template <class IsGood>
double readNumberThat(IsGood isGood, std::string_view expected, const Element& parent, std::string_view child,
                      double fallback, Context& context) {
  const Element* element = filledChild(parent, child);
  if (element == nullptr) return fallback;
  const std::optional<double> value = base::parseDouble(element->text);
  if (!value) {
    complain(*element, "a number", context);
  } else if (!isGood(*value)) {
    complain(*element, expected, context);
  } else {
    return *value;
  }
  return fallback;
}

/// Reads six numbers. Fortress runs worlds with one too few or too many, so that is no error.
std::optional<std::vector<double>> readEulerNumbers(const Element& element, Context& context) {
  constexpr std::size_t kCount = 6;
  std::optional<std::vector<double>> values = base::parseDoubles(element.text);
  if (!values || values->size() == kCount || !std::ranges::all_of(*values, [](double v) { return std::isfinite(v); })) {
    return readNumbers(element, kCount, "a pose: six finite numbers, x y z roll pitch yaw", context);
  }
  const std::string count = std::to_string(values->size()) + (values->size() == 1 ? " number" : " numbers");
  context.diagnostics.warning(
      element.position, "<pose> has " + count + " instead of six: x y z roll pitch yaw",
      values->size() < kCount ? "those that are missing are taken as zero" : "those behind the sixth are ignored");
  values->resize(kCount, 0.0);
  return values;
}

Pose readEulerPose(const Element& element, Context& context) {
  const auto values = readEulerNumbers(element, context);
  if (!values) return {};
  const std::vector<double>& v = *values;
  double unit = 1;
  if (readFlagAttribute(element, "degrees", false, context)) unit = std::numbers::pi / 180;
  return {{v[0], v[1], v[2]}, fromRollPitchYaw(v[3] * unit, v[4] * unit, v[5] * unit)};
}

Pose readQuaternionPose(const Element& element, Context& context) {
  const auto values = readNumbers(element, 7, "a pose: seven finite numbers, x y z and a quaternion x y z w", context);
  if (!values) return {};
  const std::vector<double>& v = *values;
  const Quaternion rotation(v[6], v[3], v[4], v[5]);
  const double norm = rotation.norm();
  if (!(norm > 0) || !std::isfinite(norm)) {
    complain(element, "a pose: its quaternion has no direction", context);
    return {};
  }
  return {{v[0], v[1], v[2]}, Quaternion(rotation.coeffs() / norm)};
}

}  // namespace

std::optional<std::vector<double>> readNumbers(const Element& element, std::size_t count, std::string_view expected,
                                               Context& context) {
  std::optional<std::vector<double>> values = base::parseDoubles(element.text);
  bool isGood = values && values->size() == count;
  for (std::size_t i = 0; isGood && i < count; ++i) isGood = std::isfinite((*values)[i]);
  if (isGood) return values;
  const std::string hint =
      values && values->size() != count ? "there are " + std::to_string(values->size()) + " numbers" : std::string();
  complain(element, expected, context, hint);
  return std::nullopt;
}

double readNumber(const Element& parent, std::string_view child, double fallback, Context& context) {
  return readNumberThat([](double value) { return std::isfinite(value); }, "a finite number", parent, child, fallback,
                        context);
}

double readPositive(const Element& parent, std::string_view child, double fallback, Context& context) {
  return readNumberThat([](double value) { return value > 0 && std::isfinite(value); }, "a finite number above zero",
                        parent, child, fallback, context);
}

double readNotNegative(const Element& parent, std::string_view child, double fallback, Context& context) {
  return readNumberThat([](double value) { return value >= 0 && std::isfinite(value); }, "a finite number from zero up",
                        parent, child, fallback, context);
}

double readLimit(const Element& parent, std::string_view child, double fallback, Context& context) {
  const double value =
      readNumberThat([](double number) { return !std::isnan(number); }, "a number", parent, child, fallback, context);
  return std::abs(value) >= kUnlimited ? std::copysign(std::numeric_limits<double>::infinity(), value) : value;
}

std::optional<bool> parseFlag(std::string_view text) {
  if (text == "true" || text == "1" || text == "True" || text == "TRUE") return true;
  if (text == "false" || text == "0" || text == "False" || text == "FALSE") return false;
  return std::nullopt;
}

bool readFlag(const Element& parent, std::string_view child, bool fallback, Context& context) {
  const Element* element = filledChild(parent, child);
  if (element == nullptr) return fallback;
  const std::optional<bool> flag = parseFlag(element->text);
  if (!flag) complain(*element, "'true' or 'false'", context);
  return flag.value_or(fallback);
}

bool readFlagAttribute(const Element& element, std::string_view attribute, bool fallback, Context& context) {
  const Element::Attribute* found = element.attribute(attribute);
  if (found == nullptr) return fallback;
  const std::optional<bool> flag = parseFlag(found->value);
  if (!flag) {
    context.diagnostics.error(
        found->position, "attribute '" + found->name + "' is '" + found->value + "', which is not 'true' or 'false'");
  }
  return flag.value_or(fallback);
}

Vector3 readVector(const Element& parent, std::string_view child, const Vector3& fallback, Context& context) {
  const Element* element = filledChild(parent, child);
  if (element == nullptr) return fallback;
  const auto values = readNumbers(*element, 3, "three finite numbers", context);
  return values ? Vector3((*values)[0], (*values)[1], (*values)[2]) : fallback;
}

PoseText readPose(const Element& parent, Context& context) {
  PoseText pose;
  pose.position = parent.position;
  const Element* element = parent.child("pose");
  if (element == nullptr) return pose;
  pose.position = element->position;

  if (const Element::Attribute* relativeTo = element->attribute("relative_to")) {
    pose.relativeTo = relativeTo->value;
    pose.position = relativeTo->position;
  }

  if (element->text.empty()) return pose;
  const Element::Attribute* format = element->attribute("rotation_format");
  if (format == nullptr || format->value == "euler_rpy") {
    pose.value = readEulerPose(*element, context);
  } else if (format->value == "quat_xyzw") {
    pose.value = readQuaternionPose(*element, context);
  } else {
    context.diagnostics.error(format->position, "attribute 'rotation_format' is '" + format->value +
                                                    "', which is not 'euler_rpy' or 'quat_xyzw'");
  }
  return pose;
}

std::string_view childText(const Element& parent, std::string_view child) {
  const Element* element = parent.child(child);
  return element != nullptr ? std::string_view(element->text) : std::string_view();
}

}  // namespace pongsim::sdf
