#include "plugin/fortress_systems.hh"

#include <algorithm>
#include <array>

#include "plugin/core_systems.hh"

namespace pongsim::plugin {

namespace {

constexpr auto kFortressSystems = std::to_array<std::string_view>({"ackermann-steering",
                                                                   "air-pressure",
                                                                   "altimeter",
                                                                   "apply-joint-force",
                                                                   "apply-link-wrench",
                                                                   "breadcrumbs",
                                                                   "buoyancy",
                                                                   "buoyancy-engine",
                                                                   "camera-video-recorder",
                                                                   "collada-world-exporter",
                                                                   "comms-endpoint",
                                                                   "contact",
                                                                   "detachable-joint",
                                                                   "diff-drive",
                                                                   "elevator",
                                                                   "follow-actor",
                                                                   "forcetorque",
                                                                   "hydrodynamics",
                                                                   "imu",
                                                                   "joint-controller",
                                                                   "joint-position-controller",
                                                                   "joint-state-publisher",
                                                                   "joint-trajectory-controller",
                                                                   "kinetic-energy-monitor",
                                                                   "label",
                                                                   "lift-drag",
                                                                   "linearbatteryplugin",
                                                                   "log",
                                                                   "log-video-recorder",
                                                                   "logical-camera",
                                                                   "logicalaudiosensorplugin",
                                                                   "magnetometer",
                                                                   "mecanum-drive",
                                                                   "model-photo-shoot",
                                                                   "multicopter-control",
                                                                   "multicopter-motor-model",
                                                                   "navsat",
                                                                   "odometry-publisher",
                                                                   "opticaltactileplugin",
                                                                   "particle-emitter",
                                                                   "particle-emitter2",
                                                                   "perfect-comms",
                                                                   "performer-detector",
                                                                   "physics",
                                                                   "pose-publisher",
                                                                   "rf-comms",
                                                                   "scene-broadcaster",
                                                                   "sensors",
                                                                   "shader-param",
                                                                   "thermal",
                                                                   "thermal-sensor",
                                                                   "thruster",
                                                                   "touchplugin",
                                                                   "track-controller",
                                                                   "tracked-vehicle",
                                                                   "trajectory-follower",
                                                                   "triggered-publisher",
                                                                   "user-commands",
                                                                   "velocity-control",
                                                                   "wheel-slip",
                                                                   "wind-effects"});

}  // namespace

std::span<const std::string_view> fortressSystems() { return kFortressSystems; }

std::vector<std::string_view> missingSystems(std::span<const std::string> available) {
  std::vector<std::string_view> missing;
  for (const std::string_view name : fortressSystems()) {
    const bool isHere = coreSystem(name) != nullptr || std::ranges::find(available, name) != available.end();
    if (!isHere && packageOf(name).empty()) missing.push_back(name);
  }
  return missing;
}

bool isForeignPlugin(std::string_view name) {
  constexpr std::array<std::string_view, 4> kOfRos{"gz_ros2_control-system", "ign_ros2_control-system",
                                                   "ign_ros_control-system", "gz_ros_control-system"};
  return name.starts_with("gazebo_") || std::ranges::find(kOfRos, name) != kOfRos.end();
}

std::string_view packageOf(std::string_view name) {
  if (name == "log") return "pongsim-log";
  if (name == "web" || name == "websocket-server") return "pongsim-web";
  constexpr std::array<std::string_view, 3> kOfRos2{"gz_ros2_control-system", "ign_ros2_control-system", "ros2"};
  return std::ranges::find(kOfRos2, name) != kOfRos2.end() ? "pongsim-ros2" : "";
}

}  // namespace pongsim::plugin
