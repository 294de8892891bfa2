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

constexpr LaterSystem kLaterSystems[] = {{"acoustic-comms", "Garden"},
                                         {"advanced-lift-drag", "Garden"},
                                         {"air-speed", "Garden"},
                                         {"environment-preload", "Garden"},
                                         {"environmental-sensor", "Garden"},
                                         {"lighter_than_air_dynamics", "Garden"},
                                         {"spacecraft-thruster-model", "Garden"},
                                         {"dvl", "Harmonic"},
                                         {"entity-semantics", "Harmonic"},
                                         {"lens-flare", "Harmonic"},
                                         {"python-system-loader", "Harmonic"},
                                         {"drive-to-pose-controller", "Ionic"},
                                         {"free-space-explorer", "Jetty"},
                                         {"lookup-wheel-slip", "Jetty"},
                                         {"websocket-server", "Jetty"},
                                         {"cpu-lidar", "Rotary"},
                                         {"led-plugin", "Rotary"}};

}  // namespace

std::span<const std::string_view> fortressSystems() { return kFortressSystems; }

std::span<const LaterSystem> laterSystems() { return kLaterSystems; }

bool isOfGazebo(std::string_view name) {
  return std::ranges::find(kFortressSystems, name) != std::end(kFortressSystems) ||
         std::ranges::find(kLaterSystems, name, &LaterSystem::name) != std::end(kLaterSystems);
}

bool isSupported(std::string_view name, std::span<const std::string> available) {
  return coreSystem(name) != nullptr || std::ranges::find(available, name) != available.end() ||
         !packageOf(name).empty();
}

std::vector<std::string_view> missingSystems(std::span<const std::string> available) {
  std::vector<std::string_view> missing;
  const auto addIfMissing = [&](std::string_view name) {
    if (!isSupported(name, available)) missing.push_back(name);
  };
  for (const std::string_view name : fortressSystems()) addIfMissing(name);
  for (const LaterSystem& system : laterSystems()) addIfMissing(system.name);
  return missing;
}

bool isForeignPlugin(std::string_view name) {
  constexpr std::array<std::string_view, 4> kOfRos{"gz_ros2_control-system", "ign_ros2_control-system",
                                                   "ign_ros_control-system", "gz_ros_control-system"};
  return name.starts_with("gazebo_") || std::ranges::find(kOfRos, name) != kOfRos.end();
}

std::string_view packageOf(std::string_view name) {
  if (name == "log") return "pongsim-log";
  if (name == "camera-video-recorder" || name == "log-video-recorder") return "pongsim-video";
  if (name == "web" || name == "websocket-server") return "pongsim-web";
  constexpr std::array<std::string_view, 3> kOfRos2{"gz_ros2_control-system", "ign_ros2_control-system", "ros2"};
  return std::ranges::find(kOfRos2, name) != kOfRos2.end() ? "pongsim-ros2" : "";
}

}  // namespace pongsim::plugin
