#include "msgs/state/component.hh"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "base/hash.hh"
#include "base/parse_number.hh"
#include "pongsim/components.hh"

namespace pongsim::msgs {

namespace {

// sdf::JointType of sdformat 12, starting at 1
constexpr std::array<std::string_view, 9> kJointTypes{"ball",     "continuous", "fixed", "gearbox",  "prismatic",
                                                      "revolute", "revolute2",  "screw", "universal"};

constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kSensorComponents{
    {{"imu", "Imu"},
     {"magnetometer", "Magnetometer"},
     {"altimeter", "Altimeter"},
     {"air_pressure", "AirPressureSensor"},
     {"gpu_lidar", "GpuLidar"},
     {"lidar", "Lidar"},
     {"camera", "Camera"},
     {"depth_camera", "DepthCamera"},
     {"rgbd_camera", "RgbdCamera"},
     {"thermal_camera", "ThermalCamera"},
     {"segmentation_camera", "SegmentationCamera"},
     {"boundingbox_camera", "BoundingBoxCamera"}}};

void append(double value, std::string& text) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  if (!text.empty()) text += ' ';
  text.append(digits.data(), end);
}

}  // namespace

std::uint64_t componentType(std::string_view name) {
  base::Hash hash;
  hash.add("ign_gazebo_components.");
  hash.add(name);
  return hash.value();
}

std::string componentText(double value) {
  std::string text;
  append(value, text);
  return text;
}

std::string componentText(const Vector3& vector) {
  std::string text;
  for (const double value : vector) append(value, text);
  return text;
}

std::string componentText(const Pose& pose) {
  return componentText(pose.position) + " " + componentText(rollPitchYawOf(pose.rotation));
}

std::optional<Vector3> vectorOfComponent(std::string_view text) {
  const std::optional<std::vector<double>> v = base::parseDoubles(text);
  if (!v || v->size() != 3) return std::nullopt;
  return Vector3(v->at(0), v->at(1), v->at(2));
}

std::optional<Pose> poseOfComponent(std::string_view text) {
  const std::optional<std::vector<double>> v = base::parseDoubles(text);
  if (!v || v->size() != 6) return std::nullopt;
  return Pose{{v->at(0), v->at(1), v->at(2)}, fromRollPitchYaw(v->at(3), v->at(4), v->at(5))};
}

std::string_view sensorComponent(std::string_view type) {
  const auto* const found = std::ranges::find(kSensorComponents, type, [](const auto& each) { return each.first; });
  return found == kSensorComponents.end() ? std::string_view() : found->second;
}

std::vector<std::string_view> sensorComponents() {
  std::vector<std::string_view> names;
  for (const auto& [type, component] : kSensorComponents) names.push_back(component);
  return names;
}

int jointTypeNumber(std::string_view type) {
  const auto* const found = std::ranges::find(kJointTypes, type);
  return found == kJointTypes.end() ? 0 : static_cast<int>(found - kJointTypes.begin()) + 1;
}

std::string_view jointTypeOfNumber(int number) {
  if (number < 1 || number > static_cast<int>(kJointTypes.size())) return {};
  return kJointTypes[static_cast<std::size_t>(number - 1)];
}

}  // namespace pongsim::msgs

namespace pongsim {

std::uint64_t componentType(std::string_view name) { return msgs::componentType(name); }

std::optional<Pose> componentPose(std::string_view text) { return msgs::poseOfComponent(text); }

}  // namespace pongsim
