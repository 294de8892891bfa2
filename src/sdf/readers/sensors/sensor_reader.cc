#include "sdf/readers/sensors/sensor_reader.hh"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/nearest_word.hh"
#include "pongsim/sensing/custom_type.hh"
#include "sdf/readers/sensors/camera_reader.hh"
#include "sdf/readers/sensors/lidar_reader.hh"
#include "sdf/readers/sensors/noise_reader.hh"
#include "sdf/readers/shapes/data_systems.hh"
#include "sdf/readers/worlds/plugin_reader.hh"
#include "sdf/text/names.hh"

namespace pongsim::sdf {

namespace {

std::string labelOf(const description::Sensor& sensor) {
  return sensor.name.empty() ? "a sensor" : "sensor '" + sensor.name + "'";
}

void readReferenceFrame(const Element& element, ImuSettings& settings, Context& context) {
  settings.localization = childText(element, "localization");
  if (settings.localization.empty()) settings.localization = "CUSTOM";
  if (settings.localization != "CUSTOM") return;
  const Element* rpy = element.child("custom_rpy");
  const bool isInWorld = rpy != nullptr && rpy->attributeOr("parent_frame", "") == "world";
  if (isInWorld) {
    const Vector3 angles = readVector(element, "custom_rpy", Vector3::Zero(), context);
    settings.customRotation = fromRollPitchYaw(angles.x(), angles.y(), angles.z());
    return;
  }
  // as in Fortress
  settings.localization.clear();
  if (rpy != nullptr) {
    context.diagnostics.warning(rpy->position, "<custom_rpy> is used only with parent_frame=\"world\"",
                                "the orientation is relative to the initial one instead");
  }
}

ImuSettings readImu(const Element* element, Context& context) {
  ImuSettings settings;
  if (element == nullptr) return settings;
  settings.angularVelocity = readNoise3(element->child("angular_velocity"), context);
  settings.linearAcceleration = readNoise3(element->child("linear_acceleration"), context);
  settings.enableOrientation = readFlag(*element, "enable_orientation", true, context);
  if (const Element* frame = element->child("orientation_reference_frame")) {
    readReferenceFrame(*frame, settings, context);
  }
  return settings;
}

/// Reads which collisions a contact sensor watches, and its topic, which overrides the sensor's.
ContactSettings readContact(const Element* element, const std::string& label, description::Sensor& sensor,
                            Context& context) {
  ContactSettings settings;
  sensor.topic.clear();
  if (element != nullptr) {
    for (const Element* collision : element->childrenNamed("collision")) settings.collisions.push_back(collision->text);
    const std::string_view topic = childText(*element, "topic");
    if (topic != "__default_topic__") sensor.topic = topic;
  }
  if (settings.collisions.empty()) {
    context.diagnostics.warning(sensor.position, label + " has no <collision>: it will report no contacts",
                                "write <contact><collision>NAME</collision></contact>");
  }
  return settings;
}

AltimeterSettings readAltimeter(const Element* element, Context& context) {
  if (element == nullptr) return {};
  return {readNoise(element, "vertical_position", context), readNoise(element, "vertical_velocity", context)};
}

AirPressureSettings readAirPressure(const Element* element, Context& context) {
  if (element == nullptr) return {};
  const double altitude = readNumber(*element, "reference_altitude", 0, context);
  if (altitude != 0) {
    context.diagnostics.warning(
        element->child("reference_altitude")->position,
        "<reference_altitude> has no effect, as in Fortress: altitudes are those in the world frame");
  }
  return {altitude, readNoise(element, "pressure", context)};
}

/// Reads the frame in which a force-torque sensor reports, and its direction of measurement.
void readForceTorqueFrame(const Element& element, ForceTorqueSettings& settings, Context& context) {
  using enum ForceTorqueSettings::Frame;
  constexpr std::array<std::string_view, 3> kFrameWords{"child", "parent", "sensor"};
  constexpr std::array kFrameOfName{kChild, kParent, kSensor};
  constexpr std::array<std::string_view, 2> kDirections{"child_to_parent", "parent_to_child"};
  settings.frame = kFrameOfName[readWord(element, "frame", 0, kFrameWords, context)];
  settings.isParentToChild = readWord(element, "measure_direction", 0, kDirections, context) == 1;
}

ForceTorqueSettings readForceTorque(const Element* element, Context& context) {
  ForceTorqueSettings settings;
  if (element == nullptr) return settings;
  readForceTorqueFrame(*element, settings, context);
  settings.force = readNoise3(element->child("force"), context);
  settings.torque = readNoise3(element->child("torque"), context);
  return settings;
}

NavSatSettings readNavSat(const Element* element, Context& context) {
  NavSatSettings settings;
  if (element == nullptr) return settings;
  const Element* position = element->child("position_sensing");
  settings.horizontalPosition = readNoise(position, "horizontal", context);
  settings.verticalPosition = readNoise(position, "vertical", context);
  const Element* velocity = element->child("velocity_sensing");
  settings.horizontalVelocity = readNoise(velocity, "horizontal", context);
  settings.verticalVelocity = readNoise(velocity, "vertical", context);
  return settings;
}

LogicalCameraSettings readLogicalCamera(const Element* element, const std::string& label, Context& context) {
  LogicalCameraSettings settings;
  if (element == nullptr) return settings;
  settings.near = readNotNegative(*element, "near", settings.near, context);
  settings.far = readPositive(*element, "far", settings.far, context);
  settings.horizontalFov = readPositive(*element, "horizontal_fov", settings.horizontalFov, context);
  settings.aspectRatio = readPositive(*element, "aspect_ratio", settings.aspectRatio, context);
  if (settings.horizontalFov >= std::numbers::pi) {
    context.diagnostics.error(element->child("horizontal_fov")->position, "<horizontal_fov> must be below pi");
  }
  if (settings.near >= settings.far) {
    context.diagnostics.error(element->position, label + " sees nothing: <near> must be below <far>");
  }
  return settings;
}

SonarSettings readSonar(const Element* element, Context& context) {
  using enum SonarSettings::Shape;
  constexpr std::array<std::string_view, 2> kShapes{"cone", "sphere"};
  constexpr std::array kShapeOfName{kCone, kSphere};
  SonarSettings settings;
  if (element == nullptr) return settings;
  settings.shape = kShapeOfName[readWord(*element, "geometry", 0, kShapes, context)];
  settings.minRange = readNotNegative(*element, "min", settings.minRange, context);
  settings.maxRange = readLimit(*element, "max", settings.maxRange, context);
  settings.radius = readNotNegative(*element, "radius", settings.radius, context);
  return settings;
}

TransceiverSettings readTransceiver(const Element* element, Context& context) {
  TransceiverSettings settings;
  if (element == nullptr) return settings;
  settings.essid = readText(*element, "essid", settings.essid);
  settings.frequency = readNumber(*element, "frequency", settings.frequency, context);
  settings.minFrequency = readNumber(*element, "min_frequency", settings.minFrequency, context);
  settings.maxFrequency = readNumber(*element, "max_frequency", settings.maxFrequency, context);
  settings.gain = readNumber(*element, "gain", settings.gain, context);
  settings.power = readNumber(*element, "power", settings.power, context);
  settings.sensitivity = readNumber(*element, "sensitivity", settings.sensitivity, context);
  return settings;
}

/// A type of sensor and the name of its settings element, which may have an older name too.
struct SensorType {
  std::string_view type;
  std::string_view element;
  std::string_view olderElement;
  bool isSimulated;
};

constexpr auto kSensorTypes = std::to_array<SensorType>({
    {"air_pressure", "air_pressure", "", true},
    {"air_speed", "air_speed", "", true},
    {"altimeter", "altimeter", "", true},
    {"boundingbox", "camera", "", true},
    {"boundingbox_camera", "camera", "", true},
    {"boundingbox_camera_3d", "camera", "", true},
    {"camera", "camera", "", true},
    {"contact", "contact", "", true},
    {"custom", "", "", false},
    {"depth", "camera", "", true},
    {"depth_camera", "camera", "", true},
    {"dvl", "", "", true},
    {"environmental_sensor", "", "", true},
    {"environmental_vector_sensor", "", "", true},
    {"force_torque", "force_torque", "", true},
    {"gps", "navsat", "gps", false},
    {"gpu_lidar", "lidar", "ray", true},
    {"gpu_ray", "lidar", "ray", true},
    {"imu", "imu", "", true},
    {"lidar", "lidar", "ray", true},
    {"logical_camera", "logical_camera", "", true},
    {"magnetometer", "magnetometer", "", true},
    {"multicamera", "camera", "", false},
    {"navsat", "navsat", "gps", true},
    {"ray", "lidar", "ray", true},
    {"rfid", "rfid", "", false},
    {"rfidtag", "rfidtag", "", false},
    {"rgbd", "camera", "", true},
    {"rgbd_camera", "camera", "", true},
    {"segmentation", "camera", "", true},
    {"segmentation_camera", "camera", "", true},
    {"sonar", "sonar", "", false},
    {"thermal", "camera", "", true},
    {"thermal_camera", "camera", "", true},
    {"wide_angle_camera", "camera", "", true},
    {"wideanglecamera", "camera", "", true},
    {"wireless_receiver", "transceiver", "", false},
    {"wireless_transmitter", "transceiver", "", false},
});

/// @return The sensor's type; that of a custom sensor that a system of pongsim simulates is a type of its own, and so
/// is that of a camera for boxes in space, which publishes messages of another type than those for boxes in the image.
std::string typeOf(const Element& element, const std::string& type) {
  if (type == "boundingbox" || type == "boundingbox_camera") {
    const Element* camera = element.child("camera");
    return camera != nullptr && childText(*camera, "box_type") == "3d" ? "boundingbox_camera_3d" : type;
  }
  if (type != "custom") return type;
  const std::string_view custom = customTypeOf(element);
  if (custom == "dvl") return "dvl";
  if (!custom.starts_with("environmental_sensor/")) return type;
  return childText(element, "output_format") == "vector3" ? "environmental_vector_sensor" : "environmental_sensor";
}

/// Warns about a sensor that publishes nothing because its type is not simulated; once for each type.
void warnIfSilent(const SensorType* row, const description::Sensor& sensor, Context& context) {
  if (row != nullptr && row->isSimulated) return;
  if (!context.firstTime("sensor type " + sensor.type)) return;
  if (row != nullptr) {
    context.unsimulated.warning(sensor.position, "sensor type '" + sensor.type + "' is not simulated yet");
    return;
  }
  std::vector<std::string_view> known;
  for (const SensorType& each : kSensorTypes) known.push_back(each.type);
  context.diagnostics.warning(sensor.position, "sensor type '" + sensor.type + "' is unknown",
                              base::didYouMean(sensor.type, known));
}

/// Warns about settings for other types of sensor.
void warnOfOtherTypes(const Element& element, const SensorType& row, Context& context) {
  for (const Element& child : element.children) {
    if (child.name == row.element || child.name == row.olderElement) continue;
    const bool isOfOther = std::ranges::any_of(kSensorTypes, [&](const SensorType& each) {
      return child.name == each.element || child.name == each.olderElement;
    });
    if (!isOfOther || !context.firstTime("<" + child.name + "> in a sensor of type " + std::string(row.type))) continue;
    context.diagnostics.warning(
        child.position, "<" + child.name + "> has no effect in a sensor of type '" + std::string(row.type) + "'");
  }
}

/// Reads the settings element of the sensor's own type.
SensorSettings readSettings(const Element& element, description::Sensor& sensor, Context& context) {
  const auto row = std::ranges::find(kSensorTypes, sensor.type, &SensorType::type);
  warnIfSilent(row != kSensorTypes.end() ? &*row : nullptr, sensor, context);
  if (row == kSensorTypes.end()) return {};
  warnOfOtherTypes(element, *row, context);
  const Element* own = element.child(row->element);
  if (own == nullptr && !row->olderElement.empty()) own = element.child(row->olderElement);
  const std::string label = labelOf(sensor);
  const std::string_view kind = row->element;
  if (kind == "imu") return readImu(own, context);
  if (kind == "altimeter") return readAltimeter(own, context);
  if (kind == "air_pressure") return readAirPressure(own, context);
  if (kind == "magnetometer") return MagnetometerSettings{readNoise3(own, context)};
  if (kind == "force_torque") return readForceTorque(own, context);
  if (kind == "contact") return readContact(own, label, sensor, context);
  if (kind == "camera") return readCamera(own, label, context);
  if (kind == "lidar") return readLidar(own, label, context);
  if (kind == "navsat") return readNavSat(own, context);
  if (kind == "logical_camera") return readLogicalCamera(own, label, context);
  if (kind == "sonar") return readSonar(own, context);
  if (kind == "transceiver") return readTransceiver(own, context);
  return {};
}

}  // namespace

SensorDraft readSensor(const Element& element, const std::string& owner, Context& context) {
  SensorDraft draft;
  description::Sensor& sensor = draft.sensor;
  sensor.name = readName(element, owner, context);
  sensor.position = element.position;
  sensor.sdf = element;
  draft.pose = readPose(element, context);
  sensor.topic = childText(element, "topic");
  for (const char* name : {"ignition_frame_id", "gz_frame_id", "frame_id"}) {
    if (const std::string_view frame = childText(element, name); !frame.empty()) sensor.frame = frame;
  }
  sensor.updateRate = readNotNegative(element, "update_rate", 0, context);
  sensor.alwaysOn = readFlag(element, "always_on", false, context);
  sensor.hasMetrics = readFlag(element, "enable_metrics", false, context);
  sensor.isVisualized = readFlag(element, "visualize", false, context);
  for (const Element* plugin : element.childrenNamed("plugin")) {
    sensor.plugins.push_back(readPlugin(*plugin, labelOf(sensor), context));
  }
  if (const Element::Attribute* type = element.attribute("type")) {
    sensor.type = typeOf(element, type->value);
    sensor.settings = readSettings(element, sensor, context);
    const Element* camera = element.child("camera");
    if (auto* settings = std::get_if<CameraSettings>(&sensor.settings)) {
      settings->thermal = readThermal(sensor.plugins, labelOf(sensor), context);
      if (camera != nullptr) draft.cameraPose = readPose(*camera, context);
    }
  } else {
    context.diagnostics.error(element.position, labelOf(sensor) + " has no type", "write type=\"imu\", for example");
  }
  return draft;
}

description::Sensor finishSensor(SensorDraft&& draft, const Scope& scope, const Pose& X_ScopeParent, Context& context) {
  description::Sensor sensor = std::move(draft.sensor);
  const auto resolve = [&](const PoseText& pose, const Pose& X_ScopeHolder, const std::string& what,
                           const std::string& holder) {
    if (pose.relativeTo.empty()) return pose.value;
    if (const std::optional<Scope::ResolvedFrame> frame = scope.find(pose.relativeTo)) {
      return X_ScopeHolder.inverse() * frame->X_ScopeFrame * pose.value;
    }
    // Fortress also complains, and still runs the world
    context.diagnostics.warning(
        pose.position,
        "the pose of " + what + " is relative to '" + pose.relativeTo + "', which is not in " + scope.label(),
        "it is taken as relative to " + holder);
    return pose.value;
  };
  sensor.X_ParentSensor = resolve(draft.pose, X_ScopeParent, labelOf(sensor), "what holds the sensor");
  if (auto* camera = std::get_if<CameraSettings>(&sensor.settings)) {
    camera->X_SensorCamera = resolve(draft.cameraPose, X_ScopeParent * sensor.X_ParentSensor,
                                     "the camera of " + labelOf(sensor), "the sensor");
  }
  return sensor;
}

}  // namespace pongsim::sdf
