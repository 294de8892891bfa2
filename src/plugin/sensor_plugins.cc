#include "plugin/sensor_plugins.hh"

#include <algorithm>
#include <array>

namespace pongsim::plugin {

namespace {

struct Row {
  std::string_view sensorType, system, className;
  /// Whether Fortress lacks the system, and later releases have it.
  bool isLater = false;
};

constexpr std::string_view kSensors = "sensors", kSensorsClass = "Sensors";

constexpr auto kRows = std::to_array<Row>({
    {"air_pressure", "air-pressure", "AirPressure"},
    {"air_speed", "air-speed", "AirSpeed", true},
    {"altimeter", "altimeter", "Altimeter"},
    {"boundingbox", kSensors, kSensorsClass},
    {"boundingbox_camera", kSensors, kSensorsClass},
    {"boundingbox_camera_3d", kSensors, kSensorsClass},
    {"camera", kSensors, kSensorsClass},
    {"contact", "contact", "Contact"},
    {"depth", kSensors, kSensorsClass},
    {"depth_camera", kSensors, kSensorsClass},
    {"dvl", "dvl", "DopplerVelocityLogSystem", true},
    {"environmental_sensor", "environmental-sensor", "EnvironmentalSystem", true},
    {"environmental_vector_sensor", "environmental-sensor", "EnvironmentalSystem", true},
    {"force_torque", "forcetorque", "ForceTorque"},
    {"gpu_lidar", kSensors, kSensorsClass},
    {"gpu_ray", kSensors, kSensorsClass},
    {"imu", "imu", "Imu"},
    {"lidar", kSensors, kSensorsClass},
    {"logical_camera", "logical-camera", "LogicalCamera"},
    {"magnetometer", "magnetometer", "Magnetometer"},
    {"navsat", "navsat", "NavSat"},
    {"ray", kSensors, kSensorsClass},
    {"rgbd", kSensors, kSensorsClass},
    {"rgbd_camera", kSensors, kSensorsClass},
    {"segmentation", kSensors, kSensorsClass},
    {"segmentation_camera", kSensors, kSensorsClass},
    {"thermal", kSensors, kSensorsClass},
    {"thermal_camera", kSensors, kSensorsClass},
    {"wide_angle_camera", kSensors, kSensorsClass},
    {"wideanglecamera", kSensors, kSensorsClass},
});

description::Plugin pluginNamed(const std::string& prefix, std::string_view system, const std::string& scope,
                                std::string_view className) {
  description::Plugin plugin;
  plugin.filename = prefix + std::string(system) + "-system";
  plugin.className = scope + std::string(className);
  plugin.sdf.name = "plugin";
  return plugin;
}

/// @return A plugin with the names of a system of Gazebo's later releases.
description::Plugin laterPlugin(std::string_view system, std::string_view className) {
  return pluginNamed("gz-sim-", system, "gz::sim::systems::", className);
}

}  // namespace

description::Plugin fortressPlugin(std::string_view system, std::string_view className) {
  return pluginNamed("ignition-gazebo-", system, "ignition::gazebo::systems::", className);
}

description::Plugin sensorPlugin(std::string_view sensorType) {
  const auto row = std::ranges::find(kRows, sensorType, &Row::sensorType);
  if (row == kRows.end()) return {};
  return row->isLater ? laterPlugin(row->system, row->className) : fortressPlugin(row->system, row->className);
}

void SensorCheck::add(const Declaration& system) {
  for (const SensorReadings& readings : system.readings()) simulated_.insert(readings.sensorType);
  simulated_.insert(system.readTypes().begin(), system.readTypes().end());
}

void SensorCheck::add(const description::Sensor& sensor) { sensors_.push_back(&sensor); }

void SensorCheck::report(Diagnostics& diagnostics) const {
  std::vector<const description::Sensor*> silent;
  std::vector<std::string> lines;
  for (const description::Sensor* sensor : sensors_) {
    const description::Plugin plugin = sensorPlugin(sensor->type);
    if (plugin.filename.empty() || simulated_.contains(sensor->type)) continue;
    silent.push_back(sensor);
    const std::string line = "<plugin filename=\"" + plugin.filename + "\" name=\"" + plugin.className + "\"/>";
    if (std::ranges::find(lines, line) == lines.end()) lines.push_back(line);
  }
  if (silent.empty()) return;
  const std::string first = "sensor '" + silent.front()->name + "' (" + silent.front()->type + ")";
  const std::size_t others = silent.size() - 1;
  const std::string what =
      others == 0 ? first + " publishes nothing: no plugin of the world simulates it"
      : others == 1
          ? first + " and another one publish nothing: no plugin of the world simulates them"
          : first + " and " + std::to_string(others) + " others publish nothing: no plugin of the world simulates them";
  std::string hint = "add to the <world>";
  for (const std::string& line : lines) hint += " " + line;
  diagnostics.warning(silent.front()->position, what, hint);
}

}  // namespace pongsim::plugin
