#include "sdf/sensor_reader.hh"

#include <algorithm>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "sdf/names.hh"
#include "sdf/noise_reader.hh"

namespace pongsim::sdf {

namespace {

std::string labelOf(const description::Sensor& sensor) {
  return sensor.name.empty() ? "a sensor" : "sensor '" + sensor.name + "'";
}

std::string joined(std::initializer_list<std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) text.append(text.empty() ? "" : ", ").append(word);
  return text;
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
    context.diagnostics.warning(rpy->position, "<custom_rpy> counts with parent_frame=\"world\" only",
                                "the orientation is measured from the one at the start instead");
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

/// Reads whom a contact sensor watches, and its topic, which takes the place of the sensor's.
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
    context.diagnostics.warning(sensor.position, label + " names no collision: it will feel nothing",
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
  if (readNumber(*element, "reference_altitude", 0, context) != 0) {
    context.diagnostics.warning(element->child("reference_altitude")->position,
                                "<reference_altitude> is not used, as in Fortress: heights are those in the world");
  }
  return {readNoise(element, "pressure", context)};
}

/// Reads whose axes a force-torque sensor speaks of, and in which direction it measures.
void readForceTorqueFrame(const Element& element, ForceTorqueSettings& settings, Context& context) {
  const auto choose = [&](std::string_view name, std::initializer_list<std::string_view> choices) {
    const std::string_view text = childText(element, name);
    const auto found = std::ranges::find(choices, text);
    if (text.empty() || found != choices.end()) return text.empty() ? *choices.begin() : *found;
    context.diagnostics.error(element.child(name)->position,
                              "<" + std::string(name) + "> has the unknown value '" + std::string(text) + "'",
                              "it can be " + joined(choices));
    return *choices.begin();
  };
  using Frame = ForceTorqueSettings::Frame;
  const std::string_view frame = choose("frame", {"child", "parent", "sensor"});
  settings.frame = frame == "parent" ? Frame::kParent : frame == "sensor" ? Frame::kSensor : Frame::kChild;
  settings.isParentToChild = choose("measure_direction", {"child_to_parent", "parent_to_child"}) == "parent_to_child";
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

LogicalCameraSettings readLogicalCamera(const Element* element, Context& context) {
  LogicalCameraSettings settings;
  if (element == nullptr) return settings;
  settings.near = readNotNegative(*element, "near", settings.near, context);
  settings.far = readPositive(*element, "far", settings.far, context);
  settings.aspectRatio = readPositive(*element, "aspect_ratio", settings.aspectRatio, context);
  settings.horizontalFov = readPositive(*element, "horizontal_fov", settings.horizontalFov, context);
  if (settings.horizontalFov >= std::numbers::pi) {
    context.diagnostics.error(element->child("horizontal_fov")->position,
                              "<horizontal_fov> must be below half a turn (3.1416)");
  }
  if (settings.far <= settings.near) {
    context.diagnostics.error(element->position, "a logical camera sees nothing where <far> is not above <near>");
  }
  return settings;
}

/// Reads the element of the sensor's own type.
SensorSettings readSettings(const Element& element, description::Sensor& sensor, Context& context) {
  const std::string& type = sensor.type;
  if (type == "imu") return readImu(element.child("imu"), context);
  if (type == "altimeter") return readAltimeter(element.child("altimeter"), context);
  if (type == "air_pressure") return readAirPressure(element.child("air_pressure"), context);
  if (type == "magnetometer") return MagnetometerSettings{readNoise3(element.child("magnetometer"), context)};
  if (type == "force_torque") return readForceTorque(element.child("force_torque"), context);
  if (type == "navsat") return readNavSat(element.child("navsat"), context);
  if (type == "logical_camera") return readLogicalCamera(element.child("logical_camera"), context);
  if (type == "contact") return readContact(element.child("contact"), labelOf(sensor), sensor, context);
  if (context.firstTime("sensor type " + type)) {
    context.unsimulated.warning(element.position, "sensor type '" + type + "' is not simulated yet");
  }
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
  for (const char* name : {"ignition_frame_id", "gz_frame_id"}) {
    if (const std::string_view frame = childText(element, name); !frame.empty()) sensor.frame = frame;
  }
  sensor.updateRate = readNotNegative(element, "update_rate", 0, context);
  sensor.alwaysOn = readFlag(element, "always_on", false, context);
  if (const Element::Attribute* type = element.attribute("type")) {
    sensor.type = type->value;
    sensor.settings = readSettings(element, sensor, context);
  } else {
    context.diagnostics.error(element.position, labelOf(sensor) + " has no type", "write type=\"imu\", for example");
  }
  return draft;
}

description::Sensor finishSensor(SensorDraft&& draft, const Scope& scope, const Pose& X_ScopeParent, Context& context) {
  description::Sensor sensor = std::move(draft.sensor);
  sensor.X_ParentSensor = draft.pose.value;
  if (draft.pose.relativeTo.empty()) return sensor;
  if (const std::optional<Scope::Found> frame = scope.find(draft.pose.relativeTo)) {
    sensor.X_ParentSensor = X_ScopeParent.inverse() * frame->X_ScopeFrame * draft.pose.value;
  } else {
    // Fortress complains, too, and runs the world
    context.diagnostics.warning(draft.pose.position,
                                "the pose of " + labelOf(sensor) + " is relative to '" + draft.pose.relativeTo +
                                    "', which is not in " + scope.label(),
                                "it is taken as relative to what holds the sensor");
  }
  return sensor;
}

}  // namespace pongsim::sdf
