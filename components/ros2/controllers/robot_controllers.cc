#include "ros2/controllers/robot_controllers.hh"

#include <ignition/msgs/imu.pb.h>

#include <algorithm>
#include <utility>

#include "pongsim/sensing/sensor.hh"

namespace pongsim::ros2 {

namespace {

constexpr const char* kImuInterfaces[] = {"orientation.x",        "orientation.y",         "orientation.z",
                                          "orientation.w",        "angular_velocity.x",    "angular_velocity.y",
                                          "angular_velocity.z",   "linear_acceleration.x", "linear_acceleration.y",
                                          "linear_acceleration.z"};

std::optional<Sensor> imuOf(const Model& model, const std::string& name) {
  for (const Link& link : model.links()) {
    for (const Sensor& sensor : link.sensors()) {
      if (sensor.type() == "imu" && sensor.name() == name) return sensor;
    }
  }
  for (const Model& nested : model.models()) {
    if (const auto found = imuOf(nested, name)) return found;
  }
  return std::nullopt;
}

}  // namespace

RobotControllers::RobotControllers(std::shared_ptr<RosHome> home, const SystemContext& context,
                                   const std::vector<JointDriver*>& drivers, std::vector<HardwareComponent> components,
                                   const Logger& log, Options options)
    : home_(std::move(home)) {
  for (const HardwareComponent& component : components) {
    for (const HardwareComponent::Part& part : component.joints) {
      for (JointDriver* driver : drivers) {
        const auto& joints = driver->joints();
        const auto joint = std::ranges::find(joints, part.name, &ControlledJoint::name);
        if (joint == joints.end()) continue;
        hardware_.addJoint(*driver, static_cast<std::size_t>(joint - joints.begin()), part.commands, part.states);
      }
    }
    for (const HardwareComponent::Part& part : component.sensors) addSensor(context, part);
  }
  ControllerManager::Options wanted{options.name,
                                    options.nameSpace,
                                    std::move(options.files),
                                    std::move(options.remaps),
                                    home_->settings.frames,
                                    home_->tellsTransforms,
                                    options.rate};
  manager_.emplace(*home_->node, hardware_, *context.model, context.node, log, std::move(wanted));
  services_.emplace(*manager_, std::move(components), log);
  const std::string name = manager_->node().fullName();
  if (home_->managers.contains(name)) {
    log.warning("two robots have a controller manager '" + name +
                "': spawners reach one of them; give each a <namespace> in the <ros> of its <plugin>");
  }
  home_->managers.insert(name);
}

RobotControllers::~RobotControllers() {
  home_->replace(this, {});
  home_->managers.erase(home_->managers.find(manager_->node().fullName()));
}

void RobotControllers::addSensor(const SystemContext& context, const HardwareComponent::Part& part) {
  const std::optional<Sensor> sensor = imuOf(*context.model, part.name);
  if (!sensor) {
    context.diagnostics.warning(context.sdf.position, "<ros2_control> lists sensor '" + part.name +
                                                          "', which is not an IMU of model '" +
                                                          std::string(context.model->name()) + "': it is left out");
    return;
  }
  ImuReading& reading = imus_.emplace_back();
  for (const std::string& interface : part.states) {
    const auto found = std::ranges::find(kImuInterfaces, interface);
    if (found == std::end(kImuInterfaces)) continue;
    const double* value = &reading.values[static_cast<std::size_t>(found - std::begin(kImuInterfaces))];
    hardware_.addState(part.name, interface, [value] { return *value; });
  }
  reading.subscription = context.node.subscribe<ignition::msgs::IMU>(
      sensor->topic("/imu"), [&reading](const ignition::msgs::IMU& message) {
        const auto& q = message.orientation();
        const auto& turn = message.angular_velocity();
        const auto& acceleration = message.linear_acceleration();
        reading.values = {
            q.x(),           q.y(), q.z(), q.w(), turn.x(), turn.y(), turn.z(), acceleration.x(), acceleration.y(),
            acceleration.z()};
      });
}

void RobotControllers::preUpdate() {
  manager_->dispatch();
  services_->update();
  if (std::exchange(known_, manager_->version()) != manager_->version()) {
    home_->replace(this, manager_->replacedTopics());
  }
}

void RobotControllers::reset() {
  for (ImuReading& each : imus_) each.values = {0, 0, 0, 1};
  manager_->reset();
}

void RobotControllers::transfer(StateArchive& archive) {
  for (ImuReading& each : imus_) {
    for (double& value : each.values) archive(value);
  }
  archive(*manager_);
}

}  // namespace pongsim::ros2
