#include "sdf/text/values.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/nearest_word.hh"
#include "base/parse_number.hh"
#include "sdf/schema/value_check.hh"

namespace pongsim::sdf {

namespace {

constexpr double kUnlimited = 1e16;

/// Adds the error "<mass> is 'x', which is not a number".
void complain(const Element& element, std::string_view expected, Context& context, std::string hint = {}) {
  context.diagnostics.error(
      element.position,
      "<" + element.name + "> is '" + quoted(element.text) + "', which is not " + std::string(expected),
      std::move(hint));
}

void complain(const Element::Attribute& attribute, std::string_view expected, Context& context) {
  context.diagnostics.error(attribute.position, "attribute '" + attribute.name + "' is '" + quoted(attribute.value) +
                                                    "', which is not " + std::string(expected));
}

/// @return The child; null if it is missing or empty.
const Element* filledChild(const Element& parent, std::string_view child) {
  const Element* element = parent.child(child);
  return element != nullptr && !element->text.empty() ? element : nullptr;
}

/// Reports what is wrong with the element's text as a value of a type of the format.
/// @return Whether Fortress would read as much of it as it can.
bool isReadable(const Element& element, std::string_view type, Context& context) {
  const std::optional<WrongValue> wrong = checkValue(type, element.text);
  if (!wrong) return true;
  if (wrong->severity == Severity::kError) {
    complain(element, wrong->expected, context);
    return false;
  }
  context.diagnostics.warning(
      element.position,
      "<" + element.name + "> is '" + quoted(element.text) + "', which is not " + std::string(wrong->expected),
      "Fortress reads as much of it as it can");
  return true;
}

/// Reads a number for which `isGood` holds.
template <class IsGood>
double readNumberThat(IsGood isGood, std::string_view expected, const Element& parent, std::string_view child,
                      double fallback, Context& context) {
  const Element* element = filledChild(parent, child);
  if (element == nullptr) return fallback;
  std::optional<double> value = base::parseDouble(element->text);
  if (!value) {
    if (!isReadable(*element, "double", context)) return fallback;
    value = leadingNumber(element->text);
  }
  if (value && isGood(*value)) return *value;
  complain(*element, expected, context);
  return fallback;
}

std::string listOf(std::span<const std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) text.append(text.empty() ? "" : ", ").append(word);
  return text;
}

/// @param label "<frame>" or "attribute 'type'"
/// @return Its index among the words.
std::optional<std::size_t> findWord(const std::string& text, const std::string& label, const SourcePosition& position,
                                    std::span<const std::string_view> words, Context& context) {
  const auto found = std::ranges::find(words, text);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  const std::string quote = quoted(text);
  std::string hint = text.size() == quote.size() ? base::didYouMean(text, words) : std::string();
  if (hint.empty()) hint = "it can be " + listOf(words);
  context.diagnostics.error(position, label + " has the unknown value '" + quote + "'", std::move(hint));
  return std::nullopt;
}

/// Reads six numbers. A missing or extra number is not an error, because Fortress runs such worlds.
std::optional<std::vector<double>> readEulerNumbers(const Element& element, Context& context) {
  constexpr std::size_t kCount = 6;
  std::optional<std::vector<double>> values = base::parseDoubles(element.text);
  if (!values || values->size() == kCount || !std::ranges::all_of(*values, [](double v) { return std::isfinite(v); })) {
    return readNumbers(element, kCount, "a pose: six finite numbers, x y z roll pitch yaw", context);
  }
  const std::string count = std::to_string(values->size()) + (values->size() == 1 ? " number" : " numbers");
  context.diagnostics.warning(element.position, "<pose> has " + count + " instead of six: x y z roll pitch yaw",
                              values->size() < kCount ? "missing ones are zero" : "the rest are ignored");
  values->resize(kCount, 0.0);
  return values;
}

/// @return Whether the first three are a position within the limits of the physics; if not, adds an error.
bool isWithinReach(const std::vector<double>& values, const Element& element, Context& context) {
  if (std::all_of(values.begin(), values.begin() + 3, [](double x) { return std::abs(x) <= kLargestPosition; })) {
    return true;
  }
  complain(element, "a position within 1e9 m of the origin", context);
  return false;
}

Pose readEulerPose(const Element& element, Context& context) {
  const auto values = readEulerNumbers(element, context);
  if (!values || !isWithinReach(*values, element, context)) return {};
  const std::vector<double>& v = *values;
  double unit = 1;
  if (readFlagAttribute(element, "degrees", false, context)) unit = std::numbers::pi / 180;
  return {{v[0], v[1], v[2]}, fromRollPitchYaw(v[3] * unit, v[4] * unit, v[5] * unit)};
}

Pose readQuaternionPose(const Element& element, Context& context) {
  const auto values = readNumbers(element, 7, "a pose: seven finite numbers, x y z and a quaternion x y z w", context);
  if (!values || !isWithinReach(*values, element, context)) return {};
  const std::vector<double>& v = *values;
  const Quaternion rotation(v[6], v[3], v[4], v[5]);
  const double norm = rotation.norm();
  if (!(norm > 0) || !std::isfinite(norm)) {
    complain(element, "a pose: its quaternion has length zero", context);
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
  return readNumberThat([](double value) { return value >= 0 && std::isfinite(value); },
                        "a finite, non-negative number", parent, child, fallback, context);
}

double readLimit(const Element& parent, std::string_view child, double fallback, Context& context) {
  const double value =
      readNumberThat([](double number) { return !std::isnan(number); }, "a number", parent, child, fallback, context);
  return std::abs(value) >= kUnlimited ? std::copysign(std::numeric_limits<double>::infinity(), value) : value;
}

long long readInteger(const Element& parent, std::string_view child, long long fallback, long long least,
                      long long most, Context& context) {
  const Element* element = filledChild(parent, child);
  if (element == nullptr || !isReadable(*element, "int", context)) return fallback;
  const std::optional<long long> value = leadingInteger(element->text);
  if (value && *value >= least && *value <= most) return *value;
  complain(*element, "an integer from " + std::to_string(least) + " to " + std::to_string(most), context);
  return fallback;
}

std::uint32_t readUnsigned(const Element& parent, std::string_view child, std::uint32_t fallback, Context& context) {
  return static_cast<std::uint32_t>(
      readInteger(parent, child, fallback, 0, std::numeric_limits<std::uint32_t>::max(), context));
}

long long readIntegerAttribute(const Element& element, std::string_view attribute, long long fallback, long long least,
                               long long most, Context& context) {
  const Element::Attribute* found = element.attribute(attribute);
  if (found == nullptr || found->value.empty()) return fallback;
  const std::optional<long long> value = leadingInteger(found->value);
  if (value && *value >= least && *value <= most) return *value;
  complain(*found, "an integer from " + std::to_string(least) + " to " + std::to_string(most), context);
  return fallback;
}

double readNumberAttribute(const Element& element, std::string_view attribute, double fallback, Context& context) {
  const Element::Attribute* found = element.attribute(attribute);
  if (found == nullptr || found->value.empty()) return fallback;
  const std::optional<double> value = leadingNumber(found->value);
  if (value && std::isfinite(*value)) return *value;
  complain(*found, "a finite number", context);
  return fallback;
}

std::string readText(const Element& parent, std::string_view child, std::string_view fallback) {
  const Element* element = filledChild(parent, child);
  return element != nullptr ? element->text : std::string(fallback);
}

std::size_t readWord(const Element& parent, std::string_view child, std::size_t fallback,
                     std::span<const std::string_view> words, Context& context) {
  const Element* element = filledChild(parent, child);
  if (element == nullptr) return fallback;
  return findWord(element->text, "<" + element->name + ">", element->position, words, context).value_or(fallback);
}

std::size_t readWordAttribute(const Element& element, std::string_view attribute, std::size_t fallback,
                              std::span<const std::string_view> words, Context& context) {
  const Element::Attribute* found = element.attribute(attribute);
  if (found == nullptr || found->value.empty()) return fallback;
  return findWord(found->value, "attribute '" + found->name + "'", found->position, words, context).value_or(fallback);
}

description::Color readColor(const Element& parent, std::string_view child, const description::Color& fallback,
                             Context& context) {
  const Element* element = filledChild(parent, child);
  if (element == nullptr || !isReadable(*element, "color", context)) return fallback;
  const std::vector<double> values = leadingNumbers(element->text, 4);
  if (!std::ranges::all_of(values, [](double value) { return value >= 0 && std::isfinite(value); })) {
    complain(*element, "three or four finite, non-negative numbers, red green blue alpha", context);
    return fallback;
  }
  return {static_cast<float>(values[0]), static_cast<float>(values[1]), static_cast<float>(values[2]),
          values.size() > 3 ? static_cast<float>(values[3]) : 1.0F};
}

Eigen::Vector2d readVector2(const Element& parent, std::string_view child, const Eigen::Vector2d& fallback,
                            Context& context) {
  const Element* element = filledChild(parent, child);
  if (element == nullptr) return fallback;
  const auto values = readNumbers(*element, 2, "two finite numbers", context);
  return values ? Eigen::Vector2d((*values)[0], (*values)[1]) : fallback;
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
  if (!flag) complain(*found, "'true' or 'false'", context);
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
